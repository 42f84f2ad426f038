#include "tools/corridor.hpp"

#include "libautomata/finite/guard.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/limits.hpp"
#include "libplan/solve/explain.hpp"
#include "libplan/solve/route_planner.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {

double StopWatch::lap() {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> passed = now - last_;
  last_ = now;
  return passed.count();
}

AutomatonSize size_of(const automata::Dfa& dfa) {
  return {.states = dfa.states(),
          .edges = automata::count_edges(dfa),
          .symbolic_nodes = automata::count_nodes(dfa),
          .propositions = dfa.reads().size()};
}

automata::Dfa translate(ltl::Formula formula, const std::stop_token& stop) {
  ltl::Limits limits;
  limits.stop = stop;
  auto result = automata::ltlf_to_dfa(formula, limits);
  if (auto* dfa = std::get_if<automata::Dfa>(&result)) return std::move(*dfa);
  if (stop.stop_requested()) throw Interrupted();
  throw GaveUp("the automaton has more than " + std::to_string(limits.states) + " states before minimisation");
}

CorridorRun run_corridor(const plan::Map& map, const automata::Dfa& dfa, std::optional<ltl::Formula> formula,
                         std::span<const plan::PoseId> starts, const std::stop_token& stop) {
  StopWatch watch;
  Seconds seconds;
  plan::RoutePlanner planner(map, dfa);
  seconds.compose = watch.lap();
  plan::RoutePlanner::Result answer = planner.plan(starts, stop);
  seconds.solve = watch.lap();
  const auto corridor_run = [&](Destination destination) {
    seconds.certify = watch.lap();
    return CorridorRun{size_of(dfa),           planner.met(), planner.edges(),
                       std::move(destination), seconds,       {starts.begin(), starts.end()}};
  };
  if (const auto* infeasible = std::get_if<plan::Infeasible>(&answer))
    return corridor_run(formula ? plan::explain_infeasible(map, *formula, starts, stop) : *infeasible);
  auto* route = std::get_if<plan::Route>(&answer);
  if (route == nullptr) throw Interrupted();
  if (formula) return corridor_run(plan::certify(std::move(*route), map, *formula));
  return corridor_run(plan::certify_acceptance(std::move(*route), map, dfa));
}

const plan::Route* route_of(const CorridorRun& corridor_run) {
  const auto* checked = std::get_if<CheckedRoute>(&corridor_run.destination);
  return checked != nullptr ? &route_of(*checked) : nullptr;
}

std::optional<ShownRoute> shown(const CorridorRun& corridor_run) {
  const auto* checked = std::get_if<CheckedRoute>(&corridor_run.destination);
  if (checked == nullptr) return std::nullopt;
  return shown(*checked);
}

}  // namespace waymark::tools
