// Every formula as a Boolean combination of formulas of Σ₂ and Π₂ (hierarchy.hpp), for infinite words.
//
// Rules in place of automata, in three stages [ERS24]: no U under a W, at the cost of G F and F G of parts; these
// pulled out to the Boolean top; no W inside G F, no U inside F G. What comes out is made of Σ₂, G F Σ₁ and F G Π₁. Exponential
// at worst. Ours: what is in Σ₂ or Π₂ already stays as it is; of the form and of the negated form of the negation,
// made of Π₂, the smaller one is taken for each temporal formula of the Boolean top.
#pragma once
#include <cstddef>
#include <optional>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// The formula in negation normal form, without ↔ and N, and in Δ₂. nullopt when a temporal formula of its
// Boolean top needs more than `most` rewritings, or one of more than `most` subformulas.
std::optional<Formula> delta2(Formula f, std::size_t most);

}  // namespace waymark::ltl
