// The shape of a formula: the formula without the names of its propositions.
//
// Results that are computed from a formula depend on positions in the vocabulary and not on names, so two formulas of
// one shape have the same automata up to names. A shape includes the whole arena, because the order in which formulas
// were made breaks ties, and results are equal to the byte.
#pragma once
#include <string>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// Equal for f in arena 𝒜 and g in ℬ iff 𝒜 and ℬ hold the same formulas in the same order over as many propositions and
// f, g stand at the same place. Bytes without meaning. O(arena), at best right after parsing.
std::string shape(Formula f);

}  // namespace waymark::ltl
