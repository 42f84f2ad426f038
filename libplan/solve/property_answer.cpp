#include "libplan/solve/property_answer.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/formats/path_formula.hpp"
#include "libplan/solve/discounted_cost.hpp"
#include "libplan/solve/finite_horizon.hpp"
#include "libplan/solve/long_run.hpp"
#include "libplan/solve/several_objectives.hpp"
#include "libplan/solve/state_model.hpp"

namespace waymark::plan {
namespace {

using Ask = PrismProperty::Ask;
using Status = CaseAnswer::Status;

constexpr std::size_t most_unfolded = 20'000'000;

struct NoAnswer {  // thrown
  std::string reason;
};

// Decided by the proved bounds; nullopt where they lie on both sides.
std::optional<bool> compared(const PrismProperty& property, const Bounds& value) {
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

class Solver {
 public:
  explicit Solver(CaseOptions options) : options_(std::move(options)) {}

  PropertyAnswer answer(const PrismProperty& property) {
    PropertyAnswer out;
    out.answer.method = CaseMethod::ValueIteration;
    try {
      if (property.ask == Ask::Filter) {
        summarise(property, out);
      } else if (property.ask == Ask::Multi) {
        several(property, out);
      } else {
        out.answer = value(property, initial(property));
        out.verdict = property.ask == Ask::States ? std::optional(out.answer.value.lower != 0)
                                                  : compared(property, out.answer.value);
      }
    } catch (const NoAnswer& none) {
      out.answer.status = Status::Exhausted;
      out.answer.reason = none.reason;
    }
    out.answer.value = uncrossed(out.answer.value);
    if (out.range) out.range = uncrossed(*out.range);
    return out;
  }

 private:
  static const Mdp& mdp(const PrismProperty& p) { return std::get<Mdp>(p.model->model); }
  static std::uint32_t initial(const PrismProperty& p) { return mdp(p).initial(); }

  static CaseAnswer solved(double value) {
    CaseAnswer out;
    out.status = Status::Solved;
    out.method = CaseMethod::ValueIteration;
    out.value = {value, value};
    return out;
  }

  const std::vector<LetterId>& letters(const PrismProperty& p) {
    std::vector<LetterId>& out = letters_[p.model.get()];
    if (out.empty()) out = letters_of_states(mdp(p));
    return out;
  }

  // What the operators inside say of the states.
  const std::vector<StateTruth>& inside(const PrismProperty& p) {
    if (const auto known = inside_.find(&p); known != inside_.end()) return known->second;
    std::vector<StateTruth> out;
    for (const PrismProperty& nested : p.nested) out.emplace_back(path_name(nested.text), truths(nested));
    return inside_[&p] = std::move(out);
  }

  std::vector<bool> truths(const PrismProperty& p) {
    std::vector<bool> out(mdp(p).states());
    if (p.ask == Ask::Filter) {  // the same everywhere
      PropertyAnswer found;
      summarise(p, found);
      out.assign(out.size(), found.verdict.value());
      return out;
    }
    for (std::uint32_t s = 0; s < out.size(); ++s) out[s] = truth(p, s);
    return out;
  }

  bool truth(const PrismProperty& p, std::uint32_t s) {
    if (p.ask == Ask::States) return value(p, s).value.lower != 0;
    const double asked = options_.tolerance;
    for (const double tolerance : {asked, 1e-9, 1e-12}) {
      options_.tolerance = std::min(asked, tolerance);
      const std::optional<bool> holds = compared(p, value(p, s).value);
      options_.tolerance = asked;
      if (holds) return *holds;
    }
    throw NoAnswer{"the bounds do not tell whether " + p.text + " holds in state " + mdp(p).name(s)};
  }

  CaseAnswer value(const PrismProperty& p, std::uint32_t s) {
    if (options_.stop.stop_requested()) throw NoAnswer{"stopped"};
    if (p.ask == Ask::Filter) {
      PropertyAnswer found;
      summarise(p, found);
      return found.answer;
    }
    if (p.ask == Ask::Multi) throw std::invalid_argument("several objectives inside of a property");
    if (p.ask == Ask::Steady) return solved(steady(p).at(s));
    if (p.ask == Ask::States) return solved(satisfies(p, p.task.formula, s) ? 1 : 0);
    const bool whole = s == initial(p) && p.nested.empty();
    const Mdp part = whole ? Mdp() : beginning_at(mdp(p), s, letters(p), inside(p));
    const Mdp& from_s = whole ? mdp(p) : part;
    if (p.ask == Ask::Total) return total(from_s, p.task.query);
    if (p.ask == Ask::Discounted) return discounted(from_s, p);
    if (p.steps) {
      const auto found = expected_cost(from_s, {*p.steps, p.instantaneous, is_greatest(p), p.discount}, options_.stop);
      if (!found) throw NoAnswer{"stopped"};
      return solved(*found);
    }
    if (p.budget) {
      auto unfolded = spending(from_s, *p.budget, within_budget, {.states = most_unfolded, .stop = options_.stop});
      if (!unfolded) throw NoAnswer{"stopped, or more than 20,000,000 states with what was spent"};
      return task(std::make_shared<const PlanningCase>(PlanningCase{"", std::move(*unfolded), {}}), p.task);
    }
    return task(whole ? p.model : std::make_shared<const PlanningCase>(PlanningCase{"", part, {}}), p.task);
  }

  CaseAnswer task(const std::shared_ptr<const PlanningCase>& model, const CaseTask& asked) const {
    CaseAnswer out = plan::answer(*model, asked, options_);
    if (out.status == Status::Exhausted) throw NoAnswer{out.reason};
    return out;
  }

  // ---- conditions on states

  bool satisfies(const PrismProperty& p, const std::string& formula, std::uint32_t s) {
    ltl::Arena arena(mdp(p).letters().vocabulary());
    const ltl::Formula f = ltl::parse(formula, arena);
    ltl::Letter letter = mdp(p).letters()[letters(p)[s]];
    for (const auto& [name, holds] : inside(p))
      if (const auto known = arena.vocabulary().find(name); known && holds[s]) letter.insert(*known);
    return ltl::holds(ltl::Trace({letter}), f);
  }

  // ---- runs without end

  const std::vector<double>& steady(const PrismProperty& p) {
    std::vector<double>& out = steady_[&p];
    if (!out.empty()) return out;
    std::vector<double> values(mdp(p).states());
    for (std::uint32_t s = 0; s < values.size(); ++s)
      values[s] = p.about_rewards ? mdp(p).cost(s, 0) : satisfies(p, p.task.formula, s) ? 1 : 0;
    auto found = long_run(mdp(p), values, options_.stop);
    if (!found) throw NoAnswer{"no solution of the long run"};
    return out = std::move(*found);
  }

  // Infinite where a run may earn for ever. Else runs earn nothing more once they stay in an end component. The
  // greatest total is that of leaving when it pays, the least that of being free of costs as soon as it is sure.
  CaseAnswer total(const Mdp& model, CaseTask::Query query) const {
    if (query == CaseTask::Query::MinCost) {
      const std::vector<LetterId> letters = letters_of_states(model);
      const Mdp labelled = beginning_at(model, model.initial(), letters, {{"free of costs", free_for_ever(model)}});
      return task(std::make_shared<const PlanningCase>(PlanningCase{"", labelled, {}}),
                  {"", "F \"free of costs\"", CaseTask::Logic::Ltl, query});
    }
    const EndComponents components = end_components_of(model);
    for (std::uint32_t s = 0; s < model.states(); ++s)
      for (std::uint32_t k = 0; k < model.choices(s); ++k)
        if (model.cost(s, k) > 0 && !leaves(model, s, k, components)) return solved(INFINITY);
    return task(std::make_shared<const PlanningCase>(PlanningCase{"", ending_in_components(model, components), {}}),
                {"", "F end", CaseTask::Logic::Ltl, query});
  }

  CaseAnswer discounted(const Mdp& model, const PrismProperty& p) const {
    ltl::Arena arena(model.letters().vocabulary());
    const ltl::Formula ended = ltl::parse(p.task.formula, arena);
    DiscountedCosts asked{p.discount, is_greatest(p), {}};
    for (const LetterId letter : letters_of_states(model))
      asked.ended.push_back(ltl::holds(ltl::Trace({model.letters()[letter]}), ended));
    const auto found = discounted_cost(model, asked, options_.tolerance, options_.stop);
    if (!found) throw NoAnswer{"stopped"};
    CaseAnswer out = solved(0);
    out.value = *found;
    return out;
  }

  // ---- several objectives

  static bool is_greatest(const PrismProperty& p) {
    return p.task.query == CaseTask::Query::MaxProbability || p.task.query == CaseTask::Query::MaxCost;
  }

  // The vertices; of one objective under a bound on the other, the value.
  void several(const PrismProperty& p, PropertyAnswer& out) const {
    std::vector<BoundedObjective> objectives;
    for (const PrismProperty& o : p.nested)
      objectives.push_back({{o.task.formula, o.about_rewards ? &mdp(o) : nullptr, is_greatest(o)},
                            o.comparison.empty() ? std::nullopt : std::optional(o.bound)});
    auto found = several_objectives(mdp(p), objectives, std::max(options_.tolerance, 1e-9), options_.stop);
    if (!found) throw NoAnswer{"stopped"};
    out.curve = std::move(found->curve);
    out.answer = solved(found->value);
    using Kind = SeveralAnswer::Kind;
    if (found->kind == Kind::Truth) out.verdict = found->value != 0;
    if (found->kind != Kind::Infeasible) return;
    out.answer.status = Status::Infeasible;
    out.answer.reason = "no strategy meets the bound";
  }

  // ---- filters

  void summarise(const PrismProperty& p, PropertyAnswer& out) {
    const PrismProperty &what = p.nested[0], &where = p.nested[1];
    std::vector<std::uint32_t> states;
    for (std::uint32_t s = 0; s < mdp(p).states(); ++s)
      if (truth(where, s)) states.push_back(s);
    if (p.summary == "state" && states.size() != 1)
      throw std::invalid_argument("the filter state is about " + std::to_string(states.size()) + " states");
    if (states.empty() && p.summary != "count" && p.summary != "forall" && p.summary != "exists")
      throw std::invalid_argument("a filter over no state");
    if (p.summary == "state" || p.summary == "first") states.resize(1);
    if (what.is_truth()) return count(p, states, out);
    std::vector<Bounds> values;
    for (const std::uint32_t s : states) values.push_back(value(what, s).value);
    Bounds least = values[0], most = values[0], sum{0, 0};
    for (const Bounds& v : values) {
      least = {std::min(least.lower, v.lower), std::min(least.upper, v.upper)};
      most = {std::max(most.lower, v.lower), std::max(most.upper, v.upper)};
      sum = {sum.lower + v.lower, sum.upper + v.upper};
    }
    const auto n = static_cast<double>(p.summary == "avg" ? values.size() : 1);
    out.answer = solved(0);
    out.answer.value = p.summary == "max"                         ? most
                       : p.summary == "sum" || p.summary == "avg" ? Bounds{sum.lower / n, sum.upper / n}
                                                                  : least;
    if (p.summary == "range") out.range = most;
  }

  void count(const PrismProperty& p, const std::vector<std::uint32_t>& states, PropertyAnswer& out) {
    const auto satisfied = static_cast<std::size_t>(
        std::count_if(states.begin(), states.end(), [&](std::uint32_t s) { return truth_of(p.nested[0], s); }));
    if (p.summary == "count") {
      out.answer = solved(static_cast<double>(satisfied));
      return;
    }
    out.verdict = p.summary == "exists" ? satisfied > 0 : satisfied == states.size();
    out.answer = solved(*out.verdict ? 1 : 0);
  }
  bool truth_of(const PrismProperty& p, std::uint32_t s) {
    if (p.ask != Ask::Filter) return truth(p, s);
    PropertyAnswer found;
    summarise(p, found);
    return found.verdict.value();
  }

  CaseOptions options_;
  std::map<const PlanningCase*, std::vector<LetterId>> letters_;
  std::map<const PrismProperty*, std::vector<StateTruth>> inside_;
  std::map<const PrismProperty*, std::vector<double>> steady_;
};

}  // namespace

std::optional<bool> agrees(const std::string& result, const std::vector<ParetoPoint>& curve) {
  std::vector<std::string> numbers;
  bool inside = false;
  for (const char c : result) {
    inside = c == '(' || (inside && c != ')');
    if (c == '(' || (inside && c == ','))
      numbers.emplace_back();
    else if (inside && c != ' ')
      numbers.back() += c;
  }
  if (numbers.empty() || numbers.size() % 2 != 0) return std::nullopt;
  if (numbers.size() != 2 * curve.size()) return false;
  const auto is = [&](const ParetoPoint& p, std::size_t i) {
    return agrees(numbers[i], p.values[0], std::nullopt) == true &&
           agrees(numbers[i + 1], p.values[1], std::nullopt) == true;
  };
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    if (std::none_of(curve.begin(), curve.end(), [&](const ParetoPoint& p) { return is(p, i); })) return false;
  return true;
}

PropertyAnswer answer(const PrismProperty& property, const CaseOptions& options) {
  return Solver(options).answer(property);
}

}  // namespace waymark::plan
