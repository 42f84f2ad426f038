#include "libplan/model/formats/prism_properties.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/path_formula.hpp"

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Op = PrismExpressions::Op;
using Type = PrismExpressions::Type;

class PropertiesReader {
 public:
  PropertiesReader(const PrismSource& model, const PrismSource& properties, const PrismConstants& constants,
                   const ltl::Limits& limits)
      : text_(properties.text),
        name_(model.source),
        model_(model.text, model.source),
        in_(properties.text, properties.source),
        expressions_(model_),
        constants_(constants),
        limits_(limits),
        program_(read_prism_program(model_, expressions_, constants)),
        labels_(program_.labels) {}

  std::vector<PrismProperty> read() {
    define_start();
    expressions_.speak_of(in_);
    while (in_.peek().kind != PrismToken::Kind::End) item();
    expect_given(in_, constants_, program_.given);
    expressions_.speak_of(model_);
    for (std::size_t i = 0; i < out_.size(); ++i)
      if (out_[i].fault.empty()) out_[i].model = model(structures_[i], out_[i].instantaneous);
    return std::move(out_);
  }

 private:
  // The label "init", which every model has.
  void define_start() {
    for (const PrismProgram::Label& l : program_.labels)
      if (l.name == "init") return;
    std::string text;
    for (const PrismProgram::Variable& v : program_.variables) {
      const bool truth = v.type == Type::Bool;
      const auto value = static_cast<std::int64_t>(v.first);
      text +=
          (text.empty() ? "" : "&") + v.name + '=' + (truth ? (value != 0 ? "true" : "false") : std::to_string(value));
    }
    PrismTokens tokens(text, "");
    const PrismToken name{PrismToken::Kind::String, "init", {}};
    expressions_.define_label(name, program_.start ? *program_.start : expressions_.parse(tokens));
  }

  void item() {
    if (in_.accept(";")) return;
    if (in_.accept("const")) return read_prism_constant(in_, expressions_, constants_, program_.given);
    if (in_.accept("label")) {
      const PrismToken name = in_.next();
      if (name.kind != PrismToken::Kind::String) in_.fail(name.where, "expected the name of a label in quotes");
      in_.expect("=");
      expressions_.define_label(name, expressions_.parse(in_));
      in_.expect(";");
      return;
    }
    property();
  }

  bool at_operator() const {
    return in_.is("P") || in_.is("Pmin") || in_.is("Pmax") || in_.is("R") || in_.is("Rmin") || in_.is("Rmax");
  }

  void property() {
    const std::size_t begin = in_.peek().where.begin;
    PrismProperty out;
    out.result = result(std::string_view(text_).substr(from_, begin - from_));
    structures_.emplace_back();
    try {
      question(out);
    } catch (const ltl::SyntaxError& error) {
      out.fault = error.message();
    } catch (const std::invalid_argument& error) {
      out.fault = error.what();
    }
    std::size_t end = last_;
    if (!out.fault.empty()) {  // the rest of it is skipped
      const auto line = [&](std::size_t at) { return text_.substr(0, at).rfind('\n'); };
      std::size_t previous = begin;
      while (in_.peek().kind != PrismToken::Kind::End && !in_.is(";") &&
             !(at_operator() && in_.peek().where.begin != begin && line(in_.peek().where.begin) != line(previous))) {
        previous = end = in_.next().where.end;
      }
    }
    out.text = text_.substr(begin, std::max(end, begin) - begin);
    from_ = std::max(end, begin);
    out_.push_back(std::move(out));
  }

  void question(PrismProperty& out) {
    if (in_.peek().kind == PrismToken::Kind::String && in_.is(":", 1)) in_.next(), in_.next();
    if (!at_operator()) throw std::invalid_argument("this is no P or R operator");
    const std::string_view word = in_.next().text;
    const bool probability = word[0] == 'P';
    std::string_view optimum = word.substr(1);
    if (!probability && in_.accept("{")) {
      structures_.back() = std::string(in_.next().text);
      in_.expect("}");
    }
    if (optimum.empty() && (in_.is("min") || in_.is("max"))) optimum = in_.next().text;
    if (!in_.accept("=")) {
      for (const std::string_view comparison : {">=", "<=", ">", "<"})
        if (out.comparison.empty() && in_.accept(comparison)) out.comparison = comparison;
      if (out.comparison.empty()) in_.fail("expected =? or a comparison");
      const Id bound = expressions_.parse(in_);
      expressions_.expect_type(bound, Type::Double);
      out.bound = expressions_.constant(bound);
    } else {
      in_.expect("?");
    }
    in_.expect("[");
    if (probability || !steps(out)) {
      const Id path = expressions_.parse_path(in_);
      expressions_.expect_type(path, Type::Bool);
      out.task.formula = path_formula(
          expressions_, path, [this](Id e) { return name_of(e); }, labels_);
    }
    last_ = in_.expect("]").where.end;
    out.task.query = query(probability, optimum, out.comparison);
    if (!probability && structures_.back().empty() && !program_.rewards.empty())
      structures_.back() = program_.rewards[0].name;
    if (!probability && !known(structures_.back())) throw std::invalid_argument("there are no rewards of this name");
  }

  std::string name_of(Id condition) const {
    const ltl::Span where = expressions_.where(condition);
    std::string name(text_.substr(where.begin, where.end - where.begin));
    if (expressions_.op(condition) == Op::Name) name += "=true";  // a label may have this name
    return name;
  }

  // C<=k and I=k.
  bool steps(PrismProperty& out) {
    if (in_.is("S") || (in_.is("C") && !in_.is("<=", 1))) throw std::invalid_argument("rewards of runs without end");
    if (!in_.is("C") && !in_.is("I")) return false;
    out.instantaneous = in_.next().text == "I";
    in_.expect(out.instantaneous ? "=" : "<=");
    const Id bound = expressions_.parse(in_);
    expressions_.expect_type(bound, Type::Int);
    const double found = expressions_.constant(bound);
    if (!(found >= 0 && found <= 1e9)) throw std::invalid_argument("a bound on steps outside of [0, 10^9]");
    out.steps = static_cast<std::uint64_t>(found);
    return true;
  }

  // What a comparison is about: the worst strategy.
  CaseTask::Query query(bool probability, std::string_view optimum, std::string_view comparison) const {
    if (!optimum.empty() && !comparison.empty()) throw std::invalid_argument("an optimum that is compared");
    if (program_.is_mdp && optimum.empty() && comparison.empty())
      throw std::invalid_argument("of a decision process min or max is asked");
    const bool greatest = optimum == "max" || (optimum.empty() && comparison.starts_with('<'));
    if (probability)
      return greatest || !program_.is_mdp ? CaseTask::Query::MaxProbability : CaseTask::Query::MinProbability;
    return greatest && program_.is_mdp ? CaseTask::Query::MaxCost : CaseTask::Query::MinCost;
  }

  bool known(const std::string& structure) const {
    return std::any_of(program_.rewards.begin(), program_.rewards.end(),
                       [&](const PrismProgram::Rewards& r) { return r.name == structure; });
  }

  // "RESULT: value", "RESULT (N=2,K=4): value": the first that is about these constants.
  std::optional<std::string> result(std::string_view comments) const {
    constexpr std::string_view word = "RESULT";
    for (std::size_t at = comments.find(word); at != std::string_view::npos; at = comments.find(word, at + 1)) {
      const std::string_view line = comments.substr(at + word.size(), comments.find('\n', at) - at - word.size());
      const std::size_t colon = line.find(':');
      if (colon == std::string_view::npos || !about(line.substr(0, colon))) continue;
      std::string value(line.substr(colon + 1));
      value.erase(0, value.find_first_not_of(" \t"));
      value.erase(value.find_last_not_of(" \t\r") + 1);
      return value;
    }
    return std::nullopt;
  }

  bool about(std::string_view text) const {  // "(N=2, K=4)", or nothing
    std::string rest;
    for (const char c : text)
      if (std::string_view(" \t()").find(c) == std::string_view::npos) rest += c;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(','), rest.size()), equals = rest.find('=');
      if (equals >= end) return false;
      const auto given = constants_.find(rest.substr(0, equals));
      if (given != constants_.end() && given->second != rest.substr(equals + 1, end - equals - 1)) return false;
      rest.erase(0, end + 1);
    }
    return true;
  }

  std::shared_ptr<const PlanningCase> model(const std::string& structure, bool state_rewards_only) {
    std::shared_ptr<const PlanningCase>& made = models_[{structure, state_rewards_only}];
    if (made) return made;
    PrismView view{labels_, {}, state_rewards_only, &in_};
    for (std::size_t i = 0; i < program_.rewards.size() && !structure.empty(); ++i)
      if (program_.rewards[i].name == structure && !view.rewards) view.rewards = i;
    if (structure.empty() && !program_.rewards.empty() && program_.rewards[0].name.empty()) view.rewards = 0;
    made = std::make_shared<const PlanningCase>(
        PlanningCase{std::string(name_), explore(program_, expressions_, model_, view, limits_), {}});
    return made;
  }

  std::string_view text_, name_;
  PrismTokens model_, in_;
  PrismExpressions expressions_;
  const PrismConstants& constants_;
  const ltl::Limits& limits_;
  PrismProgram program_;
  std::vector<PrismProgram::Label> labels_;  // that properties speak of
  std::vector<std::string> structures_;      // of rewards, by property
  std::vector<PrismProperty> out_;
  std::map<std::pair<std::string, bool>, std::shared_ptr<const PlanningCase>> models_;  // by structure
  std::size_t from_ = 0, last_ = 0;                                                     // where the last property ended
};

std::optional<double> number(std::string_view text) {
  double out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

}  // namespace

std::vector<PrismProperty> parse_prism_properties(const PrismSource& model, const PrismSource& properties,
                                                  const PrismConstants& constants, const ltl::Limits& limits) {
  return PropertiesReader(model, properties, constants, limits).read();
}

std::optional<bool> agrees(const std::string& result, double value, std::optional<bool> verdict) {
  if (result == "true" || result == "false")
    return verdict ? std::optional<bool>(*verdict == (result == "true")) : std::nullopt;
  if (result == "Infinity" || result == "Inf") return value == INFINITY;
  const std::size_t slash = result.find('/');
  std::optional<double> expected = number(result.substr(0, slash));
  if (slash != std::string::npos && expected) {
    const std::optional<double> below = number(result.substr(slash + 1));
    expected = below ? std::optional<double>(*expected / *below) : std::nullopt;
  }
  if (!expected) return std::nullopt;
  return std::abs(value - *expected) <= std::max(1e-5 * std::abs(*expected), 1e-7);
}

}  // namespace waymark::plan
