// The explanation that no route satisfies φ: a smallest part of the task that cannot be satisfied, in words.
#pragma once
#include <span>
#include <stop_token>

#include "libltl/formula.hpp"
#include "libplan/solve/outcome.hpp"

namespace waymark::plan {

// For a formula that has no route from these starts (plan_of said Infeasible). The reason is, in this order,
//   - the formula has no finite word at all;
//   - one of its top-level conjuncts cannot be met from here, for each such conjunct the formula;
//   - no single one, but a minimal set of conjuncts together (taking any one away leaves a task that has a route);
// followed by the propositions among them that no pose or action within reach carries. Costs one translation and one
// search per conjunct. A stop request cuts it short: the reason then says only that there is no route.
Infeasible explain_infeasible(const Map& map, ltl::Formula f, std::span<const PoseId> starts,
                              std::stop_token stop = {});

}  // namespace waymark::plan
