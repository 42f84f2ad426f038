#include "libplan/plan_of.hpp"

#include <utility>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/limits.hpp"
#include "libplan/solve/explain.hpp"
#include "libplan/solve/route_planner.hpp"

namespace waymark::plan {

Planned plan_of(const Map& map, ltl::Formula f, std::span<const PoseId> starts, const PlanOptions& options) {
  for (ltl::Proposition p : ltl::propositions(f)) {  // all of them: translation may drop some
    const std::string& name = f.arena().vocabulary().name(p);
    if (!map.vocabulary().find(name)) throw unknown_proposition(map, name);
  }
  const auto translated =
      automata::ltlf_to_dfa(f, ltl::Limits{.states = options.automaton_states, .stop = options.stop});
  if (options.stop.stop_requested() || std::holds_alternative<automata::Exhausted>(translated)) return Exhausted{};
  auto answer = RoutePlanner(map, std::get<automata::Dfa>(translated)).plan(starts, options.stop);
  if (auto* route = std::get_if<Route>(&answer)) return certify(std::move(*route), map, f);
  if (auto* infeasible = std::get_if<Infeasible>(&answer))
    return options.explain ? explain_infeasible(map, f, starts, options.stop) : std::move(*infeasible);
  return std::get<Exhausted>(answer);
}

}  // namespace waymark::plan
