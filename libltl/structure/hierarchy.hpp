// The place of a formula in the syntactic future hierarchy, for infinite words. [ERS24]
//
// Σ₀ = Π₀ = Δ₀ are the formulas without temporal operators. Σᵢ₊₁ contains Πᵢ and is closed under ∧, ∨, X and U (hence F
// and M). Πᵢ₊₁ contains Σᵢ and is closed under ∧, ∨, X and R (hence G and W). Δᵢ are the Boolean combinations of the
// two. Σ₁ is syntactically co-safe, Π₁ safe, Δ₁ an obligation, Π₂ recurrence, Σ₂ persistence. Every formula has an
// equivalent in Δ₂ (delta2.hpp). fragment.hpp recognises more formulas of the same language classes.
#pragma once
#include <cstdint>

#include "libltl/formula.hpp"

namespace waymark::ltl {

struct Level {                                 // the least i for each: f ∈ Σ_sigma, f ∈ Π_pi, f ∈ Δ_delta
  std::uint32_t sigma = 0, pi = 0, delta = 0;  // the three indices
  friend bool operator==(const Level&, const Level&) = default;
};
// N counts as X; an equivalence as both of its operands, as they are and negated. O(DAG)
Level level(Formula f);

inline bool is_delta2(Formula f) { return level(f).delta <= 2; }  // in Δ₂: a Boolean combination of formulas in Σ₂

}  // namespace waymark::ltl
