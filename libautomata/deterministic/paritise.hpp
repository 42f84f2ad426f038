// Deterministic automata of any acceptance condition to parity. A state has one copy for each leaf of its part of the
// alternating cycle decomposition, which is the minimum among constructions that only copy states. [CCF21, Sec. 4]
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// Deterministic in, deterministic out: parity(Min, Even, ·), at most one mark on a branch; no letter gains a branch.
// One state of budget per copy and per node of the decomposition.
TransitionRelation paritise(const TransitionRelation& automaton, Budget& budget);

}  // namespace waymark::automata
