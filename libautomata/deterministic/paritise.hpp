// Deterministic automata of any acceptance condition to parity, with as few copies of a state as any construction that
// only copies states can have: one per leaf of its part of the alternating cycle decomposition. [CCF21, Sec. 4]
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// Deterministic in, deterministic out: parity(Min, Even, ·), at most one mark on a branch; no letter gains a branch.
// One state of budget per copy and per node of the decomposition.
TransitionRelation paritise(const TransitionRelation& automaton, Budget& budget);

}  // namespace waymark::automata
