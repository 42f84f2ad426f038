#include "libplan/solve/case_task.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "libltl/parse.hpp"
#include "libltl/print.hpp"
#include "libltl/semantics.hpp"
#include "libltl/simplify.hpp"
#include "libltl/trace_check.hpp"
#include "libplan/solve/drop_conjuncts.hpp"
#include "libplan/solve/landmark_tour.hpp"
#include "libplan/solve/product_search.hpp"
#include "libplan/solve/task_automaton.hpp"

namespace waymark::plan {
namespace {

using Query = CaseTask::Query;
using Logic = CaseTask::Logic;
using Status = CaseAnswer::Status;

struct Spent {  // thrown: a limit was met
  std::string what;
};

class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

template <class Model>
class TaskSolver {
 public:
  TaskSolver(const Model& model, const CaseTask& task, const CaseOptions& options)
      : model_(model), task_(task), options_(options), arena_(model.letters().vocabulary()) {}

  CaseAnswer answer() {
    try {
      if (task_.query == Query::MinCycle)
        tour();
      else
        formula();
    } catch (const Spent& spent) {
      answer_.status = Status::Exhausted;
      answer_.reason = spent.what;
    }
    return std::move(answer_);
  }

 private:
  bool is_finite(ltl::Formula f) const { return is_finite_task(f, task_.logic); }
  TaskTable table(ltl::Formula f) {
    const auto automaton = task_automaton(f, task_.logic, task_.query,
                                          {.states = options_.states / 1000 + 1, .stop = options_.stop});
    if (!automaton) throw Spent{"no automaton within the limits"};
    return std::visit([&](const auto& found) { return sized(found); }, *automaton);
  }
  template <class Automaton>
  TaskTable sized(const Automaton& automaton) {
    answer_.automaton_states = automaton.states();
    return TaskTable(automaton, model_.letters());
  }

  void formula() {
    Clock clock;
    const ltl::Formula asked = ltl::parse(task_.formula, arena_);
    const ltl::Formula f = task_.logic == Logic::Ltl ? ltl::simplify(asked, ltl::Semantics::Infinite) : asked;
    if (const auto landmarks = visits(f); landmarks && by_search() && model_.states() >= worth_compressing)
      return visit(*landmarks, false);
    const bool negated = task_.query == Query::MinProbability && !is_finite(f);
    const TaskTable task = table(negated ? ltl::simplify(ltl::negate(f), ltl::Semantics::Infinite) : f);
    answer_.seconds.automaton = clock.lap();
    if (by_search())
      find_route(task, f, clock);
    else if (options_.method == CaseMethod::Search)
      throw std::invalid_argument("method search answers rmin, steps and cycle on deterministic models only");
    else
      decide(task, negated, clock);
    if (answer_.status == Status::Infeasible && options_.explain) explain(asked);
  }

  bool by_search() const {
    return is_cost() && model_.is_deterministic() && options_.method <= CaseMethod::Search;
  }

  // F p & F q & …, of several propositions and nothing else: landmarks to be seen in any order.
  std::optional<std::vector<std::string>> visits(ltl::Formula f) const {
    if (f.op() != ltl::Op::And || f.operands().size() > most_landmarks) return std::nullopt;
    std::vector<std::string> out;
    for (ltl::Formula g : f.operands()) {
      if (g.op() != ltl::Op::Until || g[0].op() != ltl::Op::True || g[1].op() != ltl::Op::Atom)
        return std::nullopt;
      out.push_back(arena_.vocabulary().name(g[1].proposition()));
    }
    return out;
  }

  // By landmark compression: no product, two to the power of the landmarks times their places.
  void visit(const std::vector<std::string>& landmarks, bool closed) {
    Clock clock;
    const auto found = shortest_tour(model_, landmarks, closed, options_.stop);
    answer_.seconds.solve = clock.lap();
    if (!found) throw Spent{"stopped"};
    answer_.method = CaseMethod::Search;
    if (const auto* none = std::get_if<NoLandmarkTour>(&*found)) {
      infeasible(INFINITY);
      answer_.reason = none->reason;
      return;
    }
    const double cost = std::get<LandmarkTour>(*found).cost;
    answer_.status = Status::Solved;
    answer_.value = {cost, cost};
  }

  bool is_cost() const { return task_.query == Query::MinCost || task_.query == Query::MinSteps; }

  void find_route(const TaskTable& task, ltl::Formula f, Clock& clock) {
    const auto found = search(model_, task, options_.states, options_.stop);
    answer_.seconds.solve = clock.lap();
    if (!found) throw Spent{"the search met its limit"};
    answer_.method = CaseMethod::Search;
    answer_.product_states = found->effort.met;
    answer_.product_edges = found->effort.edges;
    if (!found->route) return infeasible(INFINITY);
    certify(*found->route, f);
    answer_.status = Status::Solved;
    answer_.value = {found->route->cost, found->route->cost};
  }

  // By the definition, not by the automaton: the finite word satisfies f, and so, of a co-safe f, does all that begins
  // with it. Of another good prefix the word that stands still in its last letter is tried.
  void certify(const ChoiceRoute& route, ltl::Formula f) const {
    const ltl::Trace word = word_of(model_, route);
    const bool holds = is_finite(f)
                           ? ltl::TraceCheck(f)(ltl::Columns(word, arena_.vocabulary().size()))
                           : ltl::holds(ltl::Lasso({word.begin(), word.end()}, {word[word.size() - 1]}), f);
    if (!holds) throw std::logic_error("a route whose word does not satisfy " + ltl::print(f));
  }

  void decide(const TaskTable& task, bool negated, Clock& clock) {
    const auto product = ProductMdp<Model>::explore(model_, task, options_.states, options_.stop);
    answer_.seconds.product = clock.lap();
    if (!product) throw Spent{"the product met its limit"};
    answer_.product_states = product->states();
    answer_.product_edges = product->edges();
    const bool policies = options_.method == CaseMethod::PolicyIteration;
    answer_.method = policies ? CaseMethod::PolicyIteration : CaseMethod::ValueIteration;
    const DecisionLimits limits{
        .tolerance = options_.tolerance, .policy_iteration = policies, .stop = options_.stop};
    const auto decided = is_cost() ? least_cost(*product, limits)
                         : task_.query == Query::MaxProbability || negated
                             ? greatest_probability(*product, limits)
                             : least_probability(*product, limits);
    answer_.seconds.solve = clock.lap();
    if (!decided) throw Spent{"the bounds did not meet within the limits"};
    answer_.status = Status::Solved;
    answer_.value = negated ? Bounds{1 - decided->value.upper, 1 - decided->value.lower} : decided->value;
    if (is_cost() && answer_.value.lower == INFINITY) infeasible(INFINITY);
    if (task_.query == Query::MaxProbability && answer_.value.upper == 0) infeasible(0);
  }

  void infeasible(double value) {
    answer_.status = Status::Infeasible;
    answer_.value = {value, value};
  }

  void explain(ltl::Formula f) {
    const auto possible = [&](ltl::Formula part) {
      const TaskTable task = table(part);
      const auto product = ProductMdp<Model>::explore(model_, task, options_.states, options_.stop);
      if (!product) throw Spent{"the product met its limit"};
      const Chance found = product->starts().empty() ? Chance::None : chance(*product);
      return is_cost() ? found == Chance::Sure : found != Chance::None;
    };
    const std::size_t automaton_states = answer_.automaton_states;
    const Violation violation = fewest_dropped(f, possible);
    answer_.automaton_states = automaton_states;
    answer_.reason = reason(violation);
    for (ltl::Formula part : violation.dropped) answer_.dropped.push_back(ltl::print(part));
  }

  std::string reason(const Violation& violation) const {
    std::string out = is_cost() ? "no strategy is sure to satisfy " : "no strategy has a chance to satisfy ";
    for (std::size_t i = 0; i < violation.conflict.size(); ++i)
      out += (i == 0                               ? ""
              : i + 1 == violation.conflict.size() ? " and "
                                                   : ", ") +
             ltl::print(violation.conflict[i]);
    if (violation.conflict.size() > 1) out += " together";
    const std::vector<std::string> unseen = never_seen(model_, violation.conflict);
    for (std::size_t i = 0; i < unseen.size(); ++i)
      out += (i == 0 ? "; never seen from the start: " : ", ") + unseen[i];
    return out;
  }

  // patrol:a,b,c
  void tour() {
    constexpr std::string_view prefix = "patrol:";
    if (task_.logic != Logic::Derived || task_.formula.compare(0, prefix.size(), prefix) != 0)
      throw std::invalid_argument("query cycle answers formulas of the kind patrol:a,b,c of logic derived");
    if (options_.method > CaseMethod::Search)
      throw std::invalid_argument("query cycle is answered by method search");
    std::vector<std::string> landmarks(1);
    for (char c : task_.formula.substr(prefix.size())) {
      if (c == ',')
        landmarks.emplace_back();
      else
        landmarks.back() += c;
    }
    visit(landmarks, true);
  }

  static constexpr std::size_t worth_compressing =
      100'000;  // states; smaller products are searched as they are

  const Model& model_;
  const CaseTask& task_;
  const CaseOptions& options_;
  ltl::Arena arena_;
  CaseAnswer answer_;
};

}  // namespace

std::string_view name(CaseMethod method) {
  switch (method) {
    case CaseMethod::Best: return "best";
    case CaseMethod::Search: return "search";
    case CaseMethod::ValueIteration: return "vi";
    case CaseMethod::PolicyIteration: return "pi";
  }
  return {};
}

CaseAnswer answer(const PlanningCase& planning_case, const CaseTask& task, const CaseOptions& options) {
  return std::visit(
      [&](const auto& model) {
        return TaskSolver<std::decay_t<decltype(model)>>(model, task, options).answer();
      },
      planning_case.model);
}

}  // namespace waymark::plan
