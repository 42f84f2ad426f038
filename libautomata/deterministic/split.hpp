// A formula as a Boolean combination of formulas that may have deterministic automata of their own.
//
// Besides ∧ and ∨, these operators are distributed: F(φ ∨ ψ), G(φ ∧ ψ), G F(φ ∨ ψ), F G(φ ∧ ψ), X(φ ∧ ψ), X(φ ∨ ψ).
// Obligations are not split: their minimal automaton is no larger than the product of the automata of their parts.
#pragma once
#include <vector>

#include "libautomata/omega/acceptance.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

bool is_obligation(ltl::Formula f);  // over infinite words, by its syntax

// The e₁, e₂, … of G F e₁ ∧ G F e₂ ∧ …, all co-safe; none when the formula is not of this shape.
std::vector<ltl::Formula> recurring_parts(ltl::Formula f);

class Split {
 public:
  enum class Late : std::uint8_t { Each, Together };  // conjunctions of G F e, disjunctions of F G ¬e: one part or many
  // f in negation normal form. Throws Budget::Exceeded when there are more than Marks::most parts.
  Split(ltl::Formula f, Late late);
  const std::vector<ltl::Formula>& parts() const { return parts_; }
  // Inf(i) for part i, Fin(i) for its negation: no part is another one's.
  const Condition& over() const { return over_; }

 private:
  Condition tree(ltl::Formula f);
  Condition literal(ltl::Formula f);

  Late late_;
  std::vector<ltl::Formula> parts_;
  Condition over_;
};

}  // namespace waymark::automata
