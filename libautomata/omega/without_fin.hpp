// Any acceptance condition to generalised Büchi, by nondeterminism.
//
// The condition is a disjunction of clauses "these marks finitely often, those infinitely often". A run starts in a
// copy without marks, then picks a clause and continues in a copy without the edges that the clause forbids infinitely
// often. That copy counts the marks that the clause requires infinitely often.
#pragma once
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Clause {                // one way to satisfy the condition
  Marks finitely, infinitely;  // marks that end, marks that recur
};
// None is implied by another one. Exponentially many in the worst case; a step of budget for every sixteen pairs that
// are compared.
std::vector<Clause> clauses(const Condition& condition, Budget& budget);

// Generalised Büchi as it is; else trimmed. One state of budget per copy of a state.
TransitionRelation without_fin(const TransitionRelation& automaton, Budget& budget);

}  // namespace waymark::automata
