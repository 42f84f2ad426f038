#include "tools/plan_properties.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/jani_properties.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/finite_horizon.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

using plan::CaseAnswer;
using plan::PrismProperty;

struct Answered {  // a property
  CaseAnswer answer;
  std::optional<bool> verdict;  // of a comparison
  std::optional<bool> agrees;   // with the comment, where it says a value
};

// Decided by the proved bounds; nullopt where they lie on both sides.
std::optional<bool> verdict(const PrismProperty& property, const plan::Bounds& value) {
  const std::string& sign = property.comparison;
  const auto holds = [&](double v) {
    return sign == ">="   ? v >= property.bound
           : sign == ">"  ? v > property.bound
           : sign == "<=" ? v <= property.bound
                          : v < property.bound;
  };
  if (sign.empty() || holds(value.lower) != holds(value.upper)) return std::nullopt;
  return holds(value.lower);
}

class Properties {
 public:
  Properties(const CaseChoice& choice, const Session& session) : choice_(choice), session_(session) {}

  ExitCode answer(const PrismProperty& property) {
    if (!property.fault.empty()) {
      if (choice_.json)
        std::cout << begun(property).add("status", "not answered").add("reason", property.fault).text() << '\n';
      else
        std::cout << property.text << "  not answered: " << property.fault << '\n';
      return ExitCode::BadInput;
    }
    Answered found = solved(property);
    if (choice_.json)
      std::cout << json(property, found).text() << '\n';
    else
      print(property, found);
    if (found.answer.status == CaseAnswer::Status::Exhausted) return ExitCode::GaveUp;
    return found.agrees.value_or(found.verdict.value_or(true)) ? ExitCode::Done : ExitCode::No;
  }

 private:
  Answered solved(const PrismProperty& property) const {
    const ltl::Watch watch(granted(choice_.parallel.limits), session_.stop);
    const plan::CaseOptions options{.tolerance = choice_.tolerance, .explain = false, .stop = watch.token()};
    Answered out{
        property.steps ? of_steps(property, watch.token()) : plan::answer(*property.model, property.task, options),
        {},
        {}};
    if (out.answer.status == CaseAnswer::Status::Exhausted) {
      if (watch.overrun() != ltl::Overrun::None)
        out.answer.reason += " (" + amount(watch.overrun(), choice_.parallel.limits) + ')';
      return out;
    }
    out.verdict = verdict(property, out.answer.value);
    if (property.result) out.agrees = plan::agrees(*property.result, out.answer.value.middle(), out.verdict);
    return out;
  }

  static CaseAnswer of_steps(const PrismProperty& property, const std::stop_token& stop) {
    const auto found = plan::expected_cost(
        std::get<plan::Mdp>(property.model->model),
        {*property.steps, property.instantaneous, property.task.query == plan::CaseTask::Query::MaxCost}, stop);
    CaseAnswer out;
    out.method = plan::CaseMethod::ValueIteration;
    if (!found) {
      out.reason = "stopped";
      return out;
    }
    out.status = CaseAnswer::Status::Solved;
    out.value = {*found, *found};
    return out;
  }

  static JsonObject begun(const PrismProperty& property) {
    return JsonObject().add("property", property.text).add("result", property.result ? Json(*property.result) : Json());
  }

  static JsonObject json(const PrismProperty& property, const Answered& found) {
    const bool valued = found.answer.status != CaseAnswer::Status::Exhausted;
    const auto number = [&](double value) { return valued ? Json(value) : Json(); };
    const auto maybe = [](const std::optional<bool>& b) { return b ? Json(*b) : Json(); };
    JsonObject out = begun(property);
    out.add("status", valued ? "solved" : "exhausted")
        .add("query", plan::name(property.task.query))
        .add("formula", property.steps ? Json() : Json(property.task.formula))
        .add("value", number(found.answer.value.middle()))
        .add("lower", number(found.answer.value.lower))
        .add("upper", number(found.answer.value.upper))
        .add("verdict", maybe(found.verdict))
        .add("agrees", maybe(found.agrees));
    if (!valued) out.add("reason", found.answer.reason);
    return out;
  }

  static void print(const PrismProperty& property, const Answered& found) {
    std::cout << property.text << "  ";
    if (found.answer.status == CaseAnswer::Status::Exhausted) {
      std::cout << "gave up: " << found.answer.reason << '\n';
      return;
    }
    if (found.verdict)
      std::cout << (*found.verdict ? "true" : "false") << ": ";
    else if (!property.comparison.empty())
      std::cout << "undecided: ";
    const plan::Bounds& value = found.answer.value;
    std::cout << std::setprecision(12) << value.middle();
    if (value.lower != value.upper) std::cout << "  in [" << value.lower << ", " << value.upper << ']';
    if (property.result)
      std::cout << "  RESULT " << *property.result << ": "
                << (!found.agrees   ? "not compared"
                    : *found.agrees ? "agrees"
                                    : "DIFFERS");
    std::cout << '\n';
  }

  const CaseChoice& choice_;
  const Session& session_;
};

}  // namespace

namespace {

std::vector<PrismProperty> read_properties(const CaseChoice& choice, const ltl::Limits& limits) {
  const std::string model = read_file(choice.model);
  if (choice.model.ends_with(".jani")) {
    if (choice.properties != choice.model)
      throw UsageError("the properties of a model in JANI are those of its document: --properties " + choice.model);
    return plan::parse_jani_properties({model, choice.model}, constants_of(choice.constants), limits);
  }
  const std::string text = read_file(choice.properties);
  return plan::parse_prism_properties({model, choice.model}, {text, choice.properties}, constants_of(choice.constants),
                                      limits);
}

}  // namespace

ExitCode plan_properties(const CaseChoice& choice, const Session& session) {
  const ltl::Watch watch(granted(choice.parallel.limits), session.stop);
  std::vector<PrismProperty> properties;
  try {
    properties = read_properties(choice, {.states = plan::most_model_states, .stop = watch.token()});
  } catch (const plan::ReadingStopped&) {
    if (watch.overrun() == ltl::Overrun::None) throw Interrupted();
    throw GaveUp("gave up: " + choice.model + " has more states than were found in " +
                 amount(watch.overrun(), choice.parallel.limits));
  }
  if (properties.empty()) throw UsageError(choice.properties + " has no properties");
  Properties answers(choice, session);
  ExitCode worst = ExitCode::Done;
  for (const PrismProperty& property : properties) {
    if (session.stop.stop_requested()) throw Interrupted();
    worst = std::max(worst, answers.answer(property));
    std::cout.flush();
  }
  return worst;
}

}  // namespace waymark::tools
