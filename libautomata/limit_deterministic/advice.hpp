// The master theorem: φ as a disjunction over choices of simple conditions on suffixes of a word.
//
// For a word w let X be the subformulas ψ = φ₁ U φ₂ with w ⊨ G F ψ, and Y the subformulas φ₁ R φ₂ with w ⊨ F G ψ. On a
// late suffix, φ₁ U φ₂ means φ₁ W φ₂ if in X, else false; this turns φ into a safety formula φ[X]. With φ₁ R φ₂ read as
// true in Y and as φ₁ M φ₂ outside, the members of X become co-safe. [EKS20, the master theorem]:
//   w ⊨ φ  iff  for some X and Y   a suffix of w and what progression leaves of φ there satisfy φ[X],
//                                  w ⊨ G F ψ[Y] for all ψ in X,  w ⊨ F G ψ[X] for all ψ in Y.
// G F (φ₁ U φ₂) = G F φ₂ and F G (φ₁ R φ₂) = F G φ₂. Choices are made only where a formula in use depends on them.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::automata {

// One choice of X and Y. What is accepted from here on: `safe` and G F of each of `often`.
struct Advice {
  ltl::Formula safe;                // φ[X] ∧ G ψ[X] for the ψ in Y: no U
  std::vector<ltl::Formula> often;  // no R; none is true
  // Implies `safe`, and its automaton is often smaller: what a weak until waits for is given up, φ W ψ is G φ here.
  ltl::Formula narrow;
};

// Of φ in negation normal form without ↔ and N. Choices that are false by their look are left out. nullopt when there
// are more than that.
std::optional<std::vector<Advice>> advices(ltl::Formula f, std::size_t most);

}  // namespace waymark::automata
