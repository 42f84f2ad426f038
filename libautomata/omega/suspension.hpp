// ψ ∧ q where q only concerns the far end of the word: the automaton of q starts late.
//
// Whether q holds may be looked at from any position on, so the automaton of ψ runs alone outside its accepting
// components and is paired with that of q, from its initial state, whenever it enters one. [BBDLF13, Sec. 3]
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// Both generalised Büchi; `late` must accept uv exactly when it accepts v: purity(q).both().
// One state of budget per state made; more than Marks::most sets count as too many.
TransitionRelation compose_late(const TransitionRelation& automaton, const TransitionRelation& late,
                                Budget& budget);

}  // namespace waymark::automata
