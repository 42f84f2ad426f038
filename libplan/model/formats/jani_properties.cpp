#include "libplan/model/formats/jani_properties.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/path_formula.hpp"
#include "libplan/model/jani/jani_program.hpp"

namespace waymark::plan {
namespace {

using Id = PrismExpressions::Id;
using Op = PrismExpressions::Op;
using Type = PrismExpressions::Type;
using Place = JaniText::Id;
using Moment = JaniExpressions::Moment;

struct Earned {            // what a property adds up
  std::string expression;  // none: nothing is added up
  bool steps = false;      // on each step
  bool exit = false;       // in each state that is left
  bool operator<(const Earned& o) const {
    return std::tie(expression, steps, exit) < std::tie(o.expression, o.steps, o.exit);
  }
};

class JaniPropertiesReader {
 public:
  JaniPropertiesReader(const PrismSource& document, const PrismConstants& constants, const ltl::Limits& limits)
      : name_(document.source),
        text_(document.text, document.source),
        expressions_(text_),
        names_(text_, expressions_),
        limits_(limits),
        program_(read_jani_program(text_, expressions_, names_, constants)),
        labels_(program_.labels) {
    expect_given(text_, constants, program_.given);
  }

  std::vector<PrismProperty> read() {
    for (const Place p : text_.list(0, "properties")) {
      text_.expect_keys(p, {"name", "expression"});
      PrismProperty& out = out_.emplace_back();
      out.text = text_.text(text_.member(p, "name"));
      earned_.emplace_back();
      try {
        property(text_.member(p, "expression"), out);
      } catch (const ltl::FormatError& error) {
        const std::string_view what = error.what();
        out.fault = what.substr(0, what.find('\n'));
      } catch (const std::invalid_argument& error) {
        out.fault = error.what();
      }
    }
    for (std::size_t i = 0; i < out_.size(); ++i)
      if (out_[i].fault.empty()) out_[i].model = model(earned_[i]);
    return std::move(out_);
  }

 private:
  std::string op(Place expression) const {
    if (text_.kind(expression) != JaniText::Kind::Object) return "";
    const auto at = text_.find(expression, "op");
    return at ? text_.text(*at) : "";
  }

  // ---- what is asked

  void property(Place expression, PrismProperty& out) {
    if (op(expression) != "filter") return question(expression, out);
    text_.expect_keys(expression, {"op", "fun", "values", "states"});
    const Place states = text_.member(expression, "states"), fun = text_.member(expression, "fun");
    if (op(states) != "initial") throw std::invalid_argument("a filter over other states than the initial ones");
    question(text_.member(expression, "values"), out);
    // One state is initial: its value is every summary of values.
    const std::string& summary = text_.text(fun);
    const bool truth = !out.comparison.empty();
    if (summary == "values" || (truth && (summary == "∀" || summary == "∃"))) return;
    if (!truth && (summary == "min" || summary == "max" || summary == "sum" || summary == "avg")) return;
    throw std::invalid_argument("a filter that asks for " + summary);
  }

  void question(Place expression, PrismProperty& out) {
    static constexpr std::pair<std::string_view, std::string_view> comparisons[] = {
        {"<", ">"}, {"≤", "≥"}, {">", "<"}, {"≥", "≤"}};
    static constexpr std::pair<std::string_view, std::string_view> written[] = {
        {"<", "<"}, {"≤", "<="}, {">", ">"}, {"≥", ">="}};
    const std::string compared = op(expression);
    for (const auto& [sign, mirrored] : comparisons) {
      if (compared != sign) continue;
      text_.expect_keys(expression, {"op", "left", "right"});
      const Place left = text_.member(expression, "left"), right = text_.member(expression, "right");
      const bool first = is_value(left);
      out.bound = names_.constant(first ? right : left, Type::Double);
      for (const auto& [jani, prism] : written)
        if (jani == (first ? sign : mirrored)) out.comparison = prism;
      return value(first ? left : right, out);
    }
    value(expression, out);
  }

  bool is_value(Place expression) const {
    const std::string name = op(expression);
    return name == "Pmin" || name == "Pmax" || name == "Emin" || name == "Emax";
  }

  void value(Place expression, PrismProperty& out) {
    const std::string name = op(expression);
    if (!is_value(expression)) throw std::invalid_argument("this is no Pmin, Pmax, Emin or Emax");
    const bool greatest = name.ends_with("max");
    if (name[0] == 'P') {
      text_.expect_keys(expression, {"op", "exp"});
      out.task.query = greatest ? CaseTask::Query::MaxProbability : CaseTask::Query::MinProbability;
      out.task.formula = formula(text_.member(expression, "exp"));
      return;
    }
    out.task.query = greatest ? CaseTask::Query::MaxCost : CaseTask::Query::MinCost;
    expectation(expression, out);
  }

  void expectation(Place expression, PrismProperty& out) {
    text_.expect_keys(expression, {"op", "exp", "accumulate", "reach", "step-instant"});
    const Place exp = text_.member(expression, "exp");
    out.about_rewards = true;
    Earned& earned = earned_.back();
    earned.expression = text_.infix(exp);
    const auto reach = text_.find(expression, "reach"), instant = text_.find(expression, "step-instant");
    const bool adds = text_.find(expression, "accumulate").has_value();
    for (const Place when : text_.list(expression, "accumulate")) {
      const std::string& moment = text_.text(when);
      if (moment != "steps" && moment != "exit") throw std::invalid_argument("rewards of " + moment);
      (moment == "steps" ? earned.steps : earned.exit) = true;
    }
    if (!adds) earned.exit = true;  // of the state after the steps
    read(earned, exp);
    if ((reach && (instant || !adds)) || (!reach && !instant && !adds))
      throw std::invalid_argument(reach ? "a reward at the end of runs, or until an instant" : "a reward of no moment");
    if (!reach && !instant) {
      out.ask = PrismProperty::Ask::Total;
      return;
    }
    if (reach) {
      out.task.formula = "F (" + formula(*reach) + ")";
      return;
    }
    out.instantaneous = !adds;
    const double steps = names_.constant(*instant, Type::Int);
    if (!(steps >= 0 && steps <= 1e9)) throw std::invalid_argument("a bound on steps outside of [0, 10^9]");
    out.steps = static_cast<std::uint64_t>(steps);
  }

  // Structures of rewards are added to the program.
  void read(const Earned& earned, Place exp) {
    if (structures_.contains(earned)) return;
    PrismProgram::Rewards made;
    if (earned.exit)
      made.items.push_back({{}, names_.literal(1, Type::Bool), names_.read(exp, Type::Double, nullptr, Moment::State)});
    if (earned.steps) made.step = names_.read(exp, Type::Double, nullptr, Moment::Step);
    structures_[earned] = program_.rewards.size();
    program_.rewards.push_back(std::move(made));
  }

  // ---- path formulas

  std::string formula(Place path) {
    const Id read = this->path(path);
    expressions_.expect_type(read, Type::Bool);
    return path_formula(
        expressions_, read, [this](Id e) { return condition_.at(e); }, labels_);
  }

  static std::optional<Op> temporal(std::string_view name) {
    static constexpr std::pair<std::string_view, Op> operators[] = {
        {"F", Op::Eventually}, {"G", Op::Always}, {"U", Op::Until}, {"W", Op::WeakUntil}, {"R", Op::Release}};
    for (const auto& [text, op] : operators)
      if (text == name) return op;
    return std::nullopt;
  }

  bool is_path(Place expression, std::size_t depth = 0) const {
    const std::string name = op(expression);
    if (name.empty()) return false;
    if (depth == PrismExpressions::deepest) throw std::invalid_argument("this is nested too deeply");
    if (temporal(name)) return true;
    for (const char* key : {"left", "right", "exp"})
      if (const auto part = text_.find(expression, key))
        if (is_path(*part, depth + 1)) return true;
    return false;
  }

  Id path(Place expression) {
    if (!is_path(expression)) {
      const Id out = names_.read(expression, Type::Bool, nullptr, Moment::State);
      std::string name = text_.infix(expression);
      const bool is_name = text_.kind(expression) == JaniText::Kind::Text;
      for (const PrismProgram::Label& l : program_.labels)
        if (!is_name && l.name == name) name = '(' + name + ')';
      condition_[out] = name;
      return out;
    }
    const std::string name = op(expression);
    const auto part = [&](const char* key) { return path(text_.member(expression, key)); };
    if (const std::optional<Op> found = temporal(name)) {
      const bool one = *found == Op::Eventually || *found == Op::Always;
      one ? text_.expect_keys(expression, {"op", "exp", "step-bounds"})
          : text_.expect_keys(expression, {"op", "left", "right", "step-bounds"});
      std::vector<Id> operands = one ? std::vector{part("exp")} : std::vector{part("left"), part("right")};
      return expressions_.add_path(*found, std::move(operands), window(expression), JaniText::where(expression));
    }
    if (name == "¬") return names_.made(Op::Not, {part("exp")}, expression);
    const std::optional<Op> joins = name == "∧"   ? std::optional(Op::And)
                                    : name == "∨" ? std::optional(Op::Or)
                                    : name == "⇒" ? std::optional(Op::Implies)
                                                  : std::nullopt;
    if (!joins) throw std::invalid_argument("a path formula below the operator " + name);
    const Id left = part("left"), right = part("right");
    return names_.made(*joins, {left, right}, expression);
  }

  std::optional<PrismExpressions::Window> window(Place expression) {
    const auto at = text_.find(expression, "step-bounds");
    if (!at) return std::nullopt;
    text_.expect_keys(*at, {"lower", "lower-exclusive", "upper", "upper-exclusive"});
    const auto bound = [&](const char* key) {
      const auto value = text_.find(*at, key);
      return value ? std::optional(names_.read(*value, Type::Int, nullptr, Moment::State)) : std::nullopt;
    };
    const auto exclusive = [&](const char* key) {
      const auto value = text_.find(*at, key);
      return value && text_.truth(*value);
    };
    return PrismExpressions::Window{
        bound("lower"), bound("upper"), exclusive("lower-exclusive"), exclusive("upper-exclusive"), {}};
  }

  // ---- the model

  std::shared_ptr<const PlanningCase> model(const Earned& earned) {
    std::shared_ptr<const PlanningCase>& made = models_[earned];
    if (made) return made;
    PrismView view{labels_, {}, false, &text_};
    if (!earned.expression.empty()) view.rewards = structures_.at(earned);
    made = std::make_shared<const PlanningCase>(
        PlanningCase{std::string(name_), explore(program_, expressions_, text_, view, limits_), {}});
    return made;
  }

  std::string_view name_;
  JaniText text_;
  PrismExpressions expressions_;
  JaniExpressions names_;
  const ltl::Limits& limits_;
  PrismProgram program_;
  std::vector<PrismProgram::Label> labels_;  // that properties speak of
  std::map<Id, std::string> condition_;      // how conditions on states are called
  std::vector<PrismProperty> out_;
  std::vector<Earned> earned_;                // by property
  std::map<Earned, std::size_t> structures_;  // of rewards
  std::map<Earned, std::shared_ptr<const PlanningCase>> models_;
};

}  // namespace

std::vector<PrismProperty> parse_jani_properties(const PrismSource& document, const PrismConstants& constants,
                                                 const ltl::Limits& limits) {
  return JaniPropertiesReader(document, constants, limits).read();
}

}  // namespace waymark::plan
