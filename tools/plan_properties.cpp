#include "tools/plan_properties.hpp"

#include <algorithm>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/jani_properties.hpp"
#include "libplan/model/formats/read_model.hpp"
#include "libplan/model/prism/state_labels.hpp"
#include "libplan/model/prism/write_prism.hpp"
#include "libplan/solve/property_answer.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/rounded.hpp"

namespace waymark::tools {
namespace {

using plan::CaseAnswer;
using plan::PrismProperty;

struct Answered : plan::PropertyAnswer {  // a property
  std::optional<bool> agrees;             // with the comment, where it says a value
};

class Properties {
 public:
  Properties(const CaseChoice& choice, const Session& session) : choice_(choice), session_(session) {}

  Reply answer(const PrismProperty& property, const TextWatch& watch) const {
    if (!property.fault.empty()) return unanswered(property, property.fault);
    Answered found;
    try {
      found = solved(property, watch);
    } catch (const std::invalid_argument& error) {
      return unanswered(property, error.what());
    }
    std::ostringstream out;
    if (choice_.json)
      out << json(property, found).text() << '\n';
    else
      print(property, found, out);
    if (found.answer.status == CaseAnswer::Status::Exhausted) {
      if (session_.stop.stop_requested()) throw Interrupted();
      return {ExitCode::GaveUp, out.str()};
    }
    const bool yes = found.verdict.value_or(!is_infeasible(property, found));
    return {found.agrees.value_or(yes) ? ExitCode::Done : ExitCode::No, out.str()};
  }

 private:
  Reply unanswered(const PrismProperty& property, const std::string& reason) const {
    const bool agrees = property.result && plan::expects_error(*property.result);
    const ExitCode code = agrees ? ExitCode::Done : ExitCode::BadInput;
    if (choice_.json) return {code, begun(property).add("status", "not answered").add("reason", reason).text() + '\n'};
    return {code, property.text + "  not answered: " + reason +
                      (agrees ? "  RESULT " + *property.result + ": agrees" : "") + '\n'};
  }

  Answered solved(const PrismProperty& property, const TextWatch& watch) const {
    const plan::CaseOptions options{.tolerance = choice_.tolerance, .explain = false, .stop = watch.token()};
    Answered out{plan::answer(property, options), {}};
    if (out.answer.status == CaseAnswer::Status::Exhausted) {
      if (watch.overrun() != ltl::Overrun::None)
        out.answer.reason += " (" + amount(watch.overrun(), choice_.parallel.limits) + ')';
      return out;
    }
    if (property.result && is_curve(property))
      out.agrees = plan::agrees(*property.result, out.curve);
    else if (property.result && !is_infeasible(property, out))
      out.agrees = plan::agrees(*property.result, out.answer.value.middle(), out.verdict,
                                out.range ? std::optional(out.range->middle()) : std::nullopt);
    return out;
  }

  static JsonObject begun(const PrismProperty& property) {
    return JsonObject().add("property", property.text).add("result", property.result ? Json(*property.result) : Json());
  }

  static JsonObject json(const PrismProperty& property, const Answered& found) {
    const bool valued = found.answer.status != CaseAnswer::Status::Exhausted;
    const bool met = !is_infeasible(property, found), one = valued && met && !is_curve(property);
    const auto number = [&](double value) { return one ? Json(value) : Json(); };
    const auto maybe = [](const std::optional<bool>& b) { return b ? Json(*b) : Json(); };
    JsonObject out = begun(property);
    out.add("status", !valued ? "exhausted"
                      : met   ? "solved"
                              : "infeasible")
        .add("query", plan::name(property.task.query))
        .add("formula", property.task.formula.empty() ? Json() : Json(property.task.formula))
        .add("value", number(found.answer.value.middle()))
        .add("lower", number(found.answer.value.lower))
        .add("upper", number(found.answer.value.upper))
        .add("range_end", found.range ? Json(found.range->middle()) : Json())
        .add("verdict", maybe(found.verdict))
        .add("agrees", maybe(found.agrees));
    if (property.ask == PrismProperty::Ask::Multi) out.add("points", points(property, found.curve));
    if (!valued || !met) out.add("reason", found.answer.reason);
    return out;
  }

  static void print(const PrismProperty& property, const Answered& found, std::ostream& out) {
    out << property.text << "  ";
    if (found.answer.status == CaseAnswer::Status::Exhausted) {
      out << "gave up: " << found.answer.reason << '\n';
      return;
    }
    if (found.verdict)
      out << (*found.verdict ? "true" : "false");
    else if (!property.comparison.empty())
      out << "undecided";
    if (is_curve(property)) {
      for (const plan::ParetoPoint& point : found.curve)
        out << (&point == found.curve.data() ? "" : "  ") << text(point);
      if (found.curve.empty()) out << "no strategy has finite rewards";
    } else if (is_infeasible(property, found)) {
      out << "infeasible: " << found.answer.reason;
    } else if (!property.is_truth() || !property.comparison.empty()) {  // there is a number
      if (property.is_truth()) out << ": ";
      show(found.answer.value, out);
      if (found.range) {
        out << "  to  ";
        show(*found.range, out);
      }
    }
    if (property.result)
      out << "  RESULT " << *property.result << ": "
          << (!found.agrees   ? "not compared"
              : *found.agrees ? "agrees"
                              : "DIFFERS");
    out << '\n';
  }

  // No strategy meets the bounds of several objectives. Of one, 0 and infinite are values like others.
  static bool is_infeasible(const PrismProperty& p, const plan::PropertyAnswer& found) {
    return p.ask == PrismProperty::Ask::Multi && found.answer.status == CaseAnswer::Status::Infeasible;
  }
  // Both objectives are asked for.
  static bool is_curve(const PrismProperty& p) {
    return p.ask == PrismProperty::Ask::Multi && p.nested.size() == 2 && p.nested[0].comparison.empty() &&
           p.nested[1].comparison.empty();
  }
  static std::string text(const plan::ParetoPoint& point) {
    std::ostringstream out;
    out << std::setprecision(12) << '(' << point.values[0] << ", " << point.values[1] << ')';
    return out.str();
  }
  static JsonArray points(const PrismProperty& property, const std::vector<plan::ParetoPoint>& curve) {
    JsonArray out;
    for (const plan::ParetoPoint& point : curve) {
      JsonArray values, bounds, decisions;
      for (const double value : point.values) values.add(value);
      for (const plan::Bounds& b : point.re_evaluated) bounds.add(JsonArray().add(b.lower).add(b.upper));
      const auto& mdp = std::get<plan::Mdp>(property.model->model);
      for (const plan::ParetoDecision& d : point.decisions)
        decisions.add(JsonObject().add("state", mdp.name(d.state)).add("memory", d.memory).add("action", d.action));
      out.add(JsonObject().add("values", values).add("re_evaluated", bounds).add("strategy", decisions));
    }
    return out;
  }

  static void show(const plan::Bounds& value, std::ostream& out) {
    out << std::setprecision(12) << value.middle();
    if (value.lower != value.upper) out << "  " << between(value.lower, value.upper);
  }

  const CaseChoice& choice_;
  const Session& session_;
};

bool is_in_prism(const std::string& file) {
  constexpr std::string_view others[] = {".json", ".yaml", ".yml", ".tra", ".osm", ".geojson", ".graphml"};
  return std::none_of(std::begin(others), std::end(others), [&](std::string_view end) { return file.ends_with(end); });
}

// In PRISM's language, which properties speak: propositions are labels, costs the rewards "cost".
std::string model_text(const CaseChoice& choice, const ltl::Limits& limits) {
  if (is_in_prism(choice.model)) return read_file(choice.model);
  const plan::PlanningCase read = plan::read_model(choice.model, "", limits);
  if (const auto* grid = std::get_if<plan::GridWorld>(&read.model)) return plan::write_prism(*grid);
  return plan::write_prism(plan::with_labels_on_states(std::get<plan::Mdp>(read.model)));
}

// Within the limits of a property.
std::vector<PrismProperty> properties_of(const CaseChoice& choice, const std::stop_token& stop) {
  const ltl::Watch watch(granted(choice.parallel.limits), stop);
  try {
    return read_properties(choice, {.states = plan::most_model_states, .stop = watch.token()});
  } catch (const plan::ReadingStopped&) {
    if (watch.overrun() == ltl::Overrun::None) throw Interrupted();
    throw GaveUp("gave up: " + choice.model + " has more states than were found in " +
                 amount(watch.overrun(), choice.parallel.limits));
  }
}

}  // namespace

std::vector<PrismProperty> read_properties(const CaseChoice& choice, const ltl::Limits& limits) {
  const bool jani = choice.model.ends_with(".jani");
  if (jani && choice.properties != choice.model)
    throw UsageError("the properties of a model in JANI are those of its document: --properties " + choice.model);
  const std::string text = jani ? "" : read_file(choice.properties);
  return properties_in(choice, {text, choice.properties}, limits);
}

std::vector<PrismProperty> properties_in(const CaseChoice& choice, const plan::PrismSource& text,
                                         const ltl::Limits& limits) {
  const plan::PrismConstants constants = constants_of(choice.constants);
  const bool jani = choice.model.ends_with(".jani");
  const std::string model = jani ? read_file(choice.model) : model_text(choice, limits);
  if (jani) return plan::parse_jani_properties({model, choice.model}, constants, limits);
  return plan::parse_prism_properties({model, choice.model}, text, constants, limits);
}

ExitCode plan_properties(const CaseChoice& choice, const Session& session) {
  const std::vector<PrismProperty> properties = properties_of(choice, session.stop);
  if (properties.empty()) throw UsageError(choice.properties + " has no properties");
  const Properties answers(choice, session);
  return answer_in_parallel(
      properties.size(), session.stop, choice.parallel,
      [&](std::size_t job, const TextWatch& watch) { return answers.answer(properties[job], watch); });
}

}  // namespace waymark::tools
