#include "libplan/roads/road_task.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/certify_word.hpp"
#include "libplan/solve/drop_conjuncts.hpp"

namespace waymark::plan {
namespace {

double lap(std::chrono::steady_clock::time_point& last) {
  const auto now = std::chrono::steady_clock::now();
  return std::chrono::duration<double>(now - std::exchange(last, now)).count();
}

struct LimitMet {  // thrown
  const char* what;
};

class RoadTask {
 public:
  RoadTask(const RoadGraph& graph, const RoadHierarchy& hierarchy, const CaseTask& task, const CaseOptions& options,
           const GivenAutomaton* given)
      : graph_(graph),
        hierarchy_(hierarchy),
        task_(task),
        options_(options),
        given_(given),
        arena_(graph.letters().vocabulary()) {}

  CaseAnswer answer() {
    answer_.method = CaseMethod::Search;
    try {
      solve();
    } catch (const LimitMet& limit) {
      answer_.status = CaseAnswer::Status::Exhausted;
      answer_.reason = limit.what;
    }
    return std::move(answer_);
  }

 private:
  void solve() {
    auto last = std::chrono::steady_clock::now();
    std::optional<ltl::Formula> asked, f;
    if (given_ == nullptr) {
      asked = ltl::parse(task_.formula, arena_);
      f = task_.logic == CaseTask::Logic::Ltl ? ltl::simplify(*asked, ltl::Semantics::Infinite) : *asked;
    }
    const automata::Dfa dfa = made(f ? task_automaton(*f, task_.logic, task_.query, automaton_limit())
                                     : task_automaton(*given_, task_.query, automaton_limit()));
    answer_.automaton_states = dfa.states();
    answer_.seconds.automaton = lap(last);
    const RoadAnswer found = search(dfa);
    answer_.product_states = found.statistics.met;
    answer_.product_edges = found.statistics.edges;
    if (!found.route) {
      answer_.status = CaseAnswer::Status::Infeasible;
      answer_.value = {INFINITY, INFINITY};
      answer_.seconds.solve = lap(last);
      return explain(asked);
    }
    const ltl::Trace word = word_of(*found.route);
    if (f)
      certify_word(word, *f, task_.logic);
    else
      certify_word(word, graph_.letters().vocabulary(), dfa);
    answer_.seconds.solve = lap(last);
    answer_.status = CaseAnswer::Status::Solved;
    const auto cost = static_cast<double>(found.route->cost);
    answer_.value = {cost, cost};
    if (options_.route) answer_.routes.push_back(named(*found.route));
  }

  ltl::Limits automaton_limit() const { return {.states = options_.states / 1000 + 1, .stop = options_.stop}; }
  static automata::Dfa made(std::optional<TaskAutomaton> automaton) {
    if (!automaton) throw LimitMet{"no automaton within the limits"};
    return std::get<automata::Dfa>(std::move(*automaton));
  }
  RoadAnswer search(const automata::Dfa& dfa) const {
    auto found = least_route(graph_, hierarchy_, TaskTable(dfa, graph_.letters()), {.stop = options_.stop});
    if (!found) throw LimitMet{"stopped"};
    return std::move(*found);
  }

  // Throws std::logic_error for a step that is no road.
  ltl::Trace word_of(const RoadRoute& route) const {
    std::vector<ltl::Letter> letters;
    for (const std::uint32_t node : route.nodes) letters.push_back(graph_.letters()[graph_.letter(node)]);
    return ltl::Trace(std::move(letters));
  }
  static NamedRoute named(const RoadRoute& route) {
    NamedRoute out{{}, {}, static_cast<double>(route.cost)};
    for (const std::uint32_t node : route.nodes) out.places.push_back(RoadGraph::name(node));
    out.actions.assign(out.places.begin() + 1, out.places.end());
    return out;
  }

  void explain(std::optional<ltl::Formula> f) {
    if (!f) {
      answer_.reason = "no strategy is sure to be accepted by the automaton";
      return;
    }
    if (!options_.explain) return;
    const auto possible = [&](ltl::Formula part) {
      return search(made(task_automaton(part, task_.logic, task_.query, automaton_limit()))).route.has_value();
    };
    const Violation violation = fewest_dropped(*f, possible);
    answer_.reason = "no route satisfies ";
    for (std::size_t i = 0; i < violation.conflict.size(); ++i)
      answer_.reason += (i == 0                               ? ""
                         : i + 1 == violation.conflict.size() ? " and "
                                                              : ", ") +
                        ltl::print(violation.conflict[i]);
    if (violation.conflict.size() > 1) answer_.reason += " together";
    for (const ltl::Formula part : violation.dropped) answer_.dropped.push_back(ltl::print(part));
  }

  const RoadGraph& graph_;
  const RoadHierarchy& hierarchy_;
  const CaseTask& task_;
  const CaseOptions& options_;
  const GivenAutomaton* given_;  // may be absent
  ltl::Arena arena_;
  CaseAnswer answer_;
};

}  // namespace

bool is_road_task(const CaseTask& task, const CaseOptions& options) {
  return (task.query == CaseTask::Query::MinCost || task.query == CaseTask::Query::MinSteps) &&
         options.method <= CaseMethod::Search && options.top == 1 && !options.strategy;
}

CaseAnswer answer(const RoadGraph& graph, const RoadHierarchy& hierarchy, const CaseTask& task,
                  const CaseOptions& options, const GivenAutomaton* given) {
  if (!is_road_task(task, options)) throw std::invalid_argument("roads answer rmin and steps by search");
  return RoadTask(graph, hierarchy, task, options, given).answer();
}

}  // namespace waymark::plan
