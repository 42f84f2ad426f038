#include "libplan/solve/case_task.hpp"

#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "libautomata/finite/dfa.hpp"
#include "libltl/limits.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/certify_word.hpp"
#include "libplan/solve/discounted.hpp"
#include "libplan/solve/drop_conjuncts.hpp"
#include "libplan/solve/greatest_cost.hpp"
#include "libplan/solve/landmark_tour.hpp"
#include "libplan/solve/least_routes.hpp"
#include "libplan/solve/product_search.hpp"

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
  TaskSolver(const Model& model, const CaseTask& task, const GivenAutomaton* given, const CaseOptions& options)
      : model_(model), task_(task), given_(given), options_(options), arena_(model.letters().vocabulary()) {}

  CaseAnswer answer() {
    try {
      check_options();
      if (task_.query == Query::MinCycle)
        tour();
      else if (given_ != nullptr)
        automaton();
      else
        formula();
    } catch (const Spent& spent) {
      answer_.status = Status::Exhausted;
      answer_.reason = spent.what;
    }
    answer_.value = uncrossed(answer_.value);
    if (answer_.strategy) answer_.strategy->re_evaluated = uncrossed(answer_.strategy->re_evaluated);
    return std::move(answer_);
  }

 private:
  void check_options() const {
    if (!task_.fault.empty()) throw std::invalid_argument(task_.fault);
    if (options_.top > 1 && !by_search())
      throw std::invalid_argument("several routes are found by method search, for rmin and steps");
    if (options_.strategy && (task_.query == Query::LeastLasso || task_.query == Query::MinCycle))
      throw std::invalid_argument("a lasso or cycle is a walk, it has no strategy");
    if (options_.method == CaseMethod::Search && !by_search() && task_.query != Query::LeastLasso &&
        task_.query != Query::MinCycle)
      throw std::invalid_argument("method search answers rmin, steps, cycle and lasso, on deterministic models only");
  }
  bool is_finite(ltl::Formula f) const { return is_finite_task(f, task_.logic); }
  ltl::Limits limit() const { return {.states = options_.states, .stop = options_.stop}; }
  ltl::Limits automaton_limit() const { return {.states = options_.states / 1000 + 1, .stop = options_.stop}; }
  template <class Automaton>
  static Automaton made(std::optional<Automaton> automaton) {
    if (!automaton) throw Spent{"no automaton within the limits"};
    return std::move(*automaton);
  }
  enum class Asked : std::uint8_t { Itself, Opposite };
  TaskTable table_of(const TaskAutomaton& automaton, Asked asked = Asked::Itself) const {
    if (asked == Asked::Opposite) return TaskTable::never(std::get<automata::Dfa>(automaton), model_.letters());
    return std::visit([&](const auto& found) { return TaskTable(found, model_.letters()); }, automaton);
  }

  void formula() {
    Clock clock;
    const ltl::Formula asked = ltl::parse(task_.formula, arena_);
    const ltl::Formula f = task_.logic == Logic::Ltl ? ltl::simplify(asked, ltl::Semantics::Infinite) : asked;
    if (task_.query == Query::LeastLasso) {
      if (task_.logic != Logic::Ltl) throw std::invalid_argument("query lasso is about infinite words");
      lasso(made(lasso_automaton(f, automaton_limit())), f, clock);
      if (answer_.status == Status::Infeasible && options_.explain) explain(asked);
      return;
    }
    if (const auto landmarks = visits(f);
        landmarks && by_search() && options_.top == 1 && !options_.strategy && model_.states() >= worth_compressing)
      return visit(*landmarks, f);
    // Least probabilities are greatest ones of the opposite.
    const bool finite = is_finite(f), negated = is_least() && !finite;
    solve(made(task_automaton(negated ? ltl::simplify(ltl::negate(f), ltl::Semantics::Infinite) : f, task_.logic,
                              task_.query, automaton_limit())),
          is_least() && finite ? Asked::Opposite : Asked::Itself, f, clock);
    if (answer_.status == Status::Infeasible && options_.explain) explain(asked);
  }

  void automaton() {
    Clock clock;
    if (task_.query == Query::LeastLasso)
      return lasso(made(lasso_automaton(*given_, automaton_limit())), std::nullopt, clock);
    const bool finite = std::holds_alternative<automata::Dfa>(*given_);
    solve(made(task_automaton(*given_, task_.query, automaton_limit())),
          is_least() && finite ? Asked::Opposite : Asked::Itself, std::nullopt, clock);
    if (answer_.status == Status::Infeasible)
      answer_.reason = is_cost() ? "no strategy is sure to be accepted by the automaton"
                                 : "no strategy has a chance to be accepted by the automaton";
  }

  void solve(const TaskAutomaton& automaton, Asked asked, std::optional<ltl::Formula> f, Clock& clock) {
    answer_.automaton_states = std::visit([](const auto& a) { return a.states(); }, automaton);
    const TaskTable task = table_of(automaton, asked);
    answer_.seconds.automaton = clock.lap();
    if (by_search())
      find_routes(task, automaton, f, clock);
    else
      decide(task, automaton, clock);
  }

  bool by_search() const { return is_cost() && model_.is_deterministic() && options_.method <= CaseMethod::Search; }

  // F p & F q & …, of several propositions and nothing else: landmarks to be seen in any order.
  std::optional<std::vector<std::string>> visits(ltl::Formula f) const {
    if (f.op() != ltl::Op::And || f.operands().size() > most_landmarks) return std::nullopt;
    std::vector<std::string> out;
    for (ltl::Formula g : f.operands()) {
      if (g.op() != ltl::Op::Until || g[0].op() != ltl::Op::True || g[1].op() != ltl::Op::Atom) return std::nullopt;
      out.push_back(arena_.vocabulary().name(g[1].proposition()));
    }
    return out;
  }

  // By landmark compression: no product, two to the power of the landmarks times their places.
  // The formula of an open tour; a closed one has none.
  void visit(const std::vector<std::string>& landmarks, std::optional<ltl::Formula> f) {
    Clock clock;
    const auto found = shortest_tour(model_, landmarks, !f, options_.stop);
    answer_.seconds.solve = clock.lap();
    if (!found) throw Spent{"stopped"};
    answer_.method = CaseMethod::Search;
    if (const auto* none = std::get_if<NoLandmarkTour>(&*found)) {
      infeasible(INFINITY);
      answer_.reason = none->reason;
      return;
    }
    const auto& tour = std::get<LandmarkTour>(*found);
    answer_.status = Status::Solved;
    answer_.value = {tour.cost, tour.cost};
    if (!options_.route || !f) return;
    const ChoiceRoute route = walk(model_, tour);
    certify_word(word_of(model_, route), *f, task_.logic);
    answer_.routes.push_back(named(model_, route));
  }

  bool is_least() const { return task_.query == Query::MinProbability; }
  bool is_cost() const { return task_.query == Query::MinCost || task_.query == Query::MinSteps; }

  void find_routes(const TaskTable& task, const TaskAutomaton& automaton, std::optional<ltl::Formula> f, Clock& clock) {
    std::vector<ChoiceRoute> routes;
    SearchStatistics statistics;
    if (options_.top > 1) {
      auto found = least_routes(Product(model_, task), options_.top, limit());
      if (!found) throw Spent{"the search met its limit"};
      routes = std::move(found->routes);
      statistics = found->statistics;
    } else {
      auto found = search(Product(model_, task), limit());
      if (!found) throw Spent{"the search met its limit"};
      if (found->route) routes.push_back(std::move(*found->route));
      statistics = found->statistics;
    }
    answer_.seconds.solve = clock.lap();
    answer_.method = CaseMethod::Search;
    answer_.product_states = statistics.met;
    answer_.product_edges = statistics.edges;
    if (routes.empty()) return infeasible(INFINITY);
    answer_.asked = options_.top;
    for (const ChoiceRoute& route : routes) {
      certify_route(route, automaton, f);
      if (options_.top > 1 || options_.route) answer_.routes.push_back(named(model_, route));
    }
    answer_.status = Status::Solved;
    answer_.value = {routes[0].cost, routes[0].cost};
    if (options_.strategy) answer_.strategy = {automaton, decisions(model_, task, routes[0]), answer_.value};
  }

  // Without a formula by a run of the automaton.
  void certify_route(const ChoiceRoute& route, const TaskAutomaton& automaton, std::optional<ltl::Formula> f) const {
    const ltl::Trace word = word_of(model_, route);
    if (f) return certify_word(word, *f, task_.logic);
    certify_word(word, arena_.vocabulary(), std::get<automata::Dfa>(automaton));
  }

  void lasso(const automata::Automaton& automaton, std::optional<ltl::Formula> f, Clock& clock) {
    if (options_.method > CaseMethod::Search) throw std::invalid_argument("query lasso is answered by method search");
    answer_.automaton_states = automaton.states();
    answer_.seconds.automaton = clock.lap();
    auto found = least_lasso(model_, automaton, options_.order, limit());
    answer_.seconds.solve = clock.lap();
    if (!found) throw Spent{"the search for a lasso met its limit"};
    answer_.method = CaseMethod::Search;
    answer_.product_states = found->statistics.met;
    answer_.product_edges = found->statistics.edges;
    if (!found->route) {
      infeasible(INFINITY);
      answer_.reason = "no walk without end satisfies the task";
      return;
    }
    const CertifiedLasso certified =
        f ? certify(std::move(*found->route), model_, *f) : certify(std::move(*found->route), model_, automaton);
    const LassoRoute& route = certified.route();
    answer_.lasso = {named(model_, route.prefix), named(model_, route.cycle), route.rounds, options_.order};
    answer_.status = Status::Solved;
    const double value = options_.order == LassoOrder::Prefix  ? route.prefix.cost
                         : options_.order == LassoOrder::Cycle ? route.cycle.cost
                                                               : route.mean();
    answer_.value = {value, value};
  }

  std::optional<Decided> decided(const ProductMdp<Model>& product) const {
    const IterationOptions limits{.tolerance = options_.tolerance,
                                  .policy_iteration = options_.method == CaseMethod::PolicyIteration,
                                  .strategy = options_.strategy,
                                  .sweepers = options_.sweepers,
                                  .memory = options_.memory,
                                  .stop = options_.stop};
    if (is_cost()) return least_cost(product, limits);
    if (task_.query == Query::Discounted) return greatest_discounted(product, options_.discount, limits);
    return greatest_probability(product, limits);
  }

  void decide(const TaskTable& task, const TaskAutomaton& automaton, Clock& clock) {
    const auto product = ProductMdp<Model>::explore(model_, task, limit(), options_.sweepers.free());
    answer_.seconds.product = clock.lap();
    if (!product) throw Spent{"the product met its limit"};
    answer_.product_states = product->states();
    answer_.product_edges = product->edges();
    if (task_.query == Query::Discounted && options_.method == CaseMethod::PolicyIteration)
      throw std::invalid_argument("query discounted is answered by method vi");
    answer_.method =
        options_.method == CaseMethod::PolicyIteration ? CaseMethod::PolicyIteration : CaseMethod::ValueIteration;
    if (task_.query == Query::MaxCost) return tell_greatest_cost(*product, clock);
    const auto found = decided(*product);
    answer_.seconds.solve = clock.lap();
    if (!found) throw Spent{"the bounds did not meet within the limits"};
    answer_.status = Status::Solved;
    const auto told = [&](const Bounds& b) { return is_least() ? Bounds{1 - b.upper, 1 - b.lower} : b; };
    answer_.value = told(found->value);
    if (found->tolerance > options_.tolerance) answer_.reason = "proved no nearer: here doubles end";
    if (!found->attained) answer_.reason = unattained(told(found->re_evaluated));
    if (is_cost() && answer_.value.lower == INFINITY) infeasible(INFINITY);
    if (is_reward() && answer_.value.upper == 0) infeasible(0);
    if (options_.strategy && answer_.status == Status::Solved && !product->starts().empty())
      answer_.strategy = {automaton, decisions(*product, found->strategy), told(found->re_evaluated)};
  }
  static std::string unattained(const Bounds& best) {
    std::ostringstream out;
    out << std::setprecision(12) << "proved, but the best strategy that was found is worth a value in [" << best.lower
        << ", " << best.upper << ']';
    return out.str();
  }
  // Of a strategy that is to be feared there is nothing to write down.
  void tell_greatest_cost(const ProductMdp<Model>& product, Clock& clock) {
    if (options_.strategy || options_.method == CaseMethod::PolicyIteration)
      throw std::invalid_argument("query rmax is answered by method vi, without a strategy");
    const auto found = greatest_cost(product, {.tolerance = options_.tolerance, .stop = options_.stop});
    answer_.seconds.solve = clock.lap();
    if (!found) throw Spent{"the bounds did not meet within the limits"};
    answer_.status = Status::Solved;
    answer_.value = *found;
  }
  bool is_reward() const { return task_.query == Query::MaxProbability || task_.query == Query::Discounted; }

  void infeasible(double value) {
    answer_.status = Status::Infeasible;
    answer_.value = {value, value};
  }

  Qualitative chances(ltl::Formula part, Query query) const {
    const TaskTable task = table_of(made(task_automaton(part, task_.logic, query, automaton_limit())));
    const auto product = ProductMdp<Model>::explore(model_, task, limit(), options_.sweepers.free());
    if (!product) throw Spent{"the product met its limit"};
    return product->starts().empty() ? Qualitative::None : qualitative(*product);
  }

  bool is_possible(ltl::Formula part) const {
    if (task_.query == Query::LeastLasso) {
      const auto found = least_lasso(model_, made(lasso_automaton(part, automaton_limit())), options_.order, limit());
      if (!found) throw Spent{"the search for a lasso met its limit"};
      return found->route.has_value();
    }
    const Qualitative found = chances(part, task_.query);
    return is_cost() ? found == Qualitative::Sure : found != Qualitative::None;
  }

  void explain(ltl::Formula f) {
    const Violation violation = fewest_dropped(f, [&](ltl::Formula part) { return is_possible(part); });
    answer_.reason = reason(violation, is_cost() && task_.logic == Logic::Ltl && is_sure_in_the_end(f));
    for (ltl::Formula part : violation.dropped) answer_.dropped.push_back(ltl::print(part));
  }
  // Is some strategy sure to satisfy the formula, though not by a prefix of the run?
  bool is_sure_in_the_end(ltl::Formula f) const {
    try {
      return chances(f, Query::MaxProbability) == Qualitative::Sure;
    } catch (const Spent&) {
      return false;
    }
  }

  std::string reason(const Violation& violation, bool only_prefixes) const {
    if (only_prefixes)
      return conflict_behind("no strategy is sure to come to a finite prefix that decides ", violation);
    std::string out = task_.query == Query::LeastLasso ? conflict_behind("no walk without end satisfies ", violation)
                                                       : in_words(violation, is_cost());
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
    if (options_.method > CaseMethod::Search) throw std::invalid_argument("query cycle is answered by method search");
    std::vector<std::string> landmarks(1);
    for (char c : task_.formula.substr(prefix.size())) {
      if (c == ',')
        landmarks.emplace_back();
      else
        landmarks.back() += c;
    }
    visit(landmarks, std::nullopt);
  }

  static constexpr std::size_t worth_compressing = 100'000;  // states; smaller products are searched as they are

  const Model& model_;
  const CaseTask& task_;
  const GivenAutomaton* given_;  // may be absent
  const CaseOptions& options_;
  ltl::Arena arena_;
  CaseAnswer answer_;
};

CaseAnswer solve(const PlanningCase& planning_case, const CaseTask& task, const GivenAutomaton* given,
                 const CaseOptions& options) {
  return std::visit(
      [&](const auto& model) {
        return TaskSolver<std::decay_t<decltype(model)>>(model, task, given, options).answer();
      },
      planning_case.model);
}

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
  return solve(planning_case, task, nullptr, options);
}

CaseAnswer answer(const PlanningCase& planning_case, const CaseTask& task, const GivenAutomaton& given,
                  const CaseOptions& options) {
  return solve(planning_case, task, &given, options);
}

}  // namespace waymark::plan
