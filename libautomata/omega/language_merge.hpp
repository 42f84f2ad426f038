// States of one language merged where that is safe: a branch to q leads to r instead when both accept the same words
// and r does not reach q. A run is redirected at most once, so the language stays.
//
// What a state of the tableau accepts is its formula; two formulas are compared by the tableau of one and not the
// other. States that some short lasso tells apart are not compared.
#pragma once
#include <vector>

#include "libautomata/effort.hpp"
#include "libautomata/omega/tableau.hpp"

namespace waymark::automata {

// Stops comparing when the effort runs out; throws only when stopped.
Branching merge_equivalent(const Tableau& tableau, const std::vector<ltl::Proposition>& reads,
                           Effort& effort);

}  // namespace waymark::automata
