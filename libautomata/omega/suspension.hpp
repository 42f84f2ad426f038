// ψ ∧ q where q depends on suffixes only: the automaton of q starts late.
//
// The verdict of q may be read from any position on. The automaton of ψ runs alone outside its accepting components,
// and is paired with the automaton of q, in its initial state, whenever a run enters one. [BBDLF13, Sec. 3]
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// Both generalised Büchi; `late` must accept uv exactly when it accepts v: purity(q).both().
// One state of budget per state made; more than Marks::most sets count as too many.
TransitionRelation compose_late(const TransitionRelation& automaton, const TransitionRelation& late, Budget& budget);

}  // namespace waymark::automata
