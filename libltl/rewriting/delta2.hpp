// The normal form in Δ₂: a Boolean combination of formulas of Σ₂ and Π₂ (hierarchy.hpp), for infinite words.
//
// Rewrite rules replace automata, in three stages [ERS24]: no U under a W, which adds G F and F G of subformulas; these
// moved to the Boolean top; no W inside G F and no U inside F G. The result consists of Σ₂, G F Σ₁ and F G Π₁, and may
// be exponentially larger. Ours: formulas in Σ₂ or Π₂ stay unchanged. For each temporal formula of the Boolean top, the
// smaller one is taken of its form and of the negated form of its negation, which consists of Π₂.
#pragma once
#include <cstddef>
#include <optional>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// The formula in negation normal form, without ↔ and N, and in Δ₂. nullopt when a temporal formula of its
// Boolean top needs more than `most` rewritings, or one of more than `most` subformulas.
std::optional<Formula> delta2(Formula f, std::size_t most);

}  // namespace waymark::ltl
