// What stays of a formula when its propositions lose their names.
//
// Nothing that is computed from a formula asks for names, only for positions in the vocabulary; so two formulas of one
// shape have the same automata, names changed. A shape speaks of the whole arena: the order in which other formulas
// were made there decides ties too, and answers are to be the same to the byte.
#pragma once
#include <string>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// Equal for f in arena 𝒜 and g in ℬ iff 𝒜 and ℬ hold the same formulas in the same order over as many propositions and f, g
// stand at the same place. Bytes without meaning. O(arena), at best right after parsing.
std::string shape(Formula f);

}  // namespace waymark::ltl
