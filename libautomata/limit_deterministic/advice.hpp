// The master theorem: φ as a choice among conditions on the far end of a word, each of them simple.
//
// For a word w let X be the subformulas ψ = φ₁ U φ₂ with w ⊨ G F ψ, and Y the subformulas φ₁ R φ₂ with w ⊨ F G ψ. Far
// enough, φ₁ U φ₂ means φ₁ W φ₂ when it is in X and false when it is not, so φ has become a safety formula φ[X]; and
// with φ₁ R φ₂ read as true in Y and as φ₁ M φ₂ outside, the members of X become co-safe. [EKS20, the master theorem]:
//   w ⊨ φ  iff  for some X and Y   a suffix of w and what is left of φ there satisfy φ[X],
//                                  w ⊨ G F ψ[Y] for all ψ in X,  w ⊨ F G ψ[X] for all ψ in Y.
// Here G F (φ₁ U φ₂) = G F φ₂ and F G (φ₁ R φ₂) = F G φ₂ are used, and a subformula is decided only when a formula that
// is asked for depends on it.
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
