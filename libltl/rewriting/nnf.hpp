// Negation normal form: ¬ stands before atoms only. The form exists on finite and infinite words, because both next
// operators exist: ¬X φ = N ¬φ, ¬N φ = X ¬φ. Source: [BK08, Def. 5.23], the weak next as in [DV13].
#pragma once
#include <unordered_map>
#include <utility>

#include "libltl/formula.hpp"

namespace waymark::ltl {

// φ ↔ ψ becomes (φ ∧ ψ) ∨ (¬φ ∧ ¬ψ). O(DAG): each subformula appears at most twice, as itself and negated.
Formula nnf(Formula f);

// The same, but an equivalence of two formulas stays, and may stay negated: ¬ before atoms and ↔ only.
Formula nnf_keeping_iff(Formula f);

// nnf_keeping_iff(¬φ) of many formulas that share parts: each part is looked at once.
class Opposites {
 public:
  Formula of(Formula f);  // O(parts that were not seen before)

 private:
  std::unordered_map<Formula, std::pair<Formula, Formula>> known_;  // normal forms of φ and of ¬φ
};

}  // namespace waymark::ltl
