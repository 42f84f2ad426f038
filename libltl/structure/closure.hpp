// The closure of φ: its subformulas and their negations, what tableaux and elementary sets are made of.
// Source: [BK08, Def. 5.34].
#pragma once
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// In creation order (operands before operators), without duplicates; closed under negate(). O(DAG · log DAG).
std::vector<Formula> closure(Formula f);

}  // namespace waymark::ltl
