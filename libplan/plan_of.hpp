// The plan of φ in one call: formula → automaton → product, never built → route → certificate.
#pragma once
#include <cstddef>
#include <span>
#include <stop_token>
#include <variant>

#include "libltl/formula.hpp"
#include "libplan/certify.hpp"
#include "libplan/solve/outcome.hpp"

namespace waymark::plan {

using Planned = std::variant<CertifiedRoute, Infeasible, Exhausted>;  // what planning comes to

struct PlanOptions {                         // limits of planning
  std::size_t automaton_states = 1'000'000;  // more than that: Exhausted
  bool explain = true;                       // find the reason of an Infeasible: costs more than finding that it is one
  std::stop_token stop = {};                 // ends with Exhausted when it is asked for
};

// A least-cost route from one of the starts whose word satisfies f, then stop (conventions.md 4). Throws
// ltl::FormatError naming a proposition of f that the map lacks. Who asks about one formula many times keeps a
// RoutePlanner (route_planner.hpp).
Planned plan_of(const Map& map, ltl::Formula f, std::span<const PoseId> starts, const PlanOptions& options = {});
inline Planned plan_of(const Map& map, ltl::Formula f, PoseId start, const PlanOptions& options = {}) {
  return plan_of(map, f, {&start, 1}, options);
}

}  // namespace waymark::plan
