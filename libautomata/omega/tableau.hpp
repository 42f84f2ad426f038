// LTL → transition-based generalised Büchi automata, by a tableau whose successor sets are decision diagrams.
//
// A state is a conjunction of formulas in negation normal form. Its successors are one MTBDD built bottom up; the
// leaves are antichains of (promises, next conjunction): [Cou99, Sec. 4]. The diagram decides the letters, which are
// part of the products there:
//   δ(φ U ψ) = δ(ψ) ∪ (δ(φ) ⊗ {(P(ψ), φ U ψ)})    δ(φ R ψ) = δ(ψ) ⊗ (δ(φ) ∪ {(∅, φ R ψ)})    δ(X φ) = {(∅, φ)}
// ∪ and ⊗ drop a branch when another branch promises no more and leaves no more. A promise is named by its final goal:
// φ U (χ U ψ) and χ U ψ both promise ψ. Mark i on an edge means that the edge does not make promise i. Formulas with
// one successor diagram are one state.
#pragma once
#include <memory>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

struct Tableau {
  TransitionRelation automaton;       // neither trimmed nor reduced
  std::vector<ltl::Formula> meaning;  // by state: what is accepted from it
};

// φ in negation normal form, without ↔. reads[v] is the proposition of variable v.
// Throws what the budget throws; too many promises count as too many states.
Tableau tableau(ltl::Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget);

// Whether formulas can be satisfied. Their tableaux are one, which grows from question to question: many questions
// about parts of one formula cost little more than the largest of them.
class Satisfiability {
 public:
  // Formulas of that arena, over these propositions; all three must stay.
  Satisfiability(ltl::Arena& arena, const std::vector<ltl::Proposition>& reads, Budget& budget);
  ~Satisfiability();
  bool operator()(ltl::Formula f);  // in negation normal form, without ↔. Throws what the budget throws

 private:
  class Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace waymark::automata
