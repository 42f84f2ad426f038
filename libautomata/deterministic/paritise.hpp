// Deterministic automata of any acceptance condition to parity, with as few copies of a state as any construction that
// only copies states can have: one per leaf of its part of the alternating cycle decomposition. [CCF21, Sec. 4]
#pragma once
#include "libautomata/effort.hpp"
#include "libautomata/omega/branching.hpp"

namespace waymark::automata {

// Deterministic in, deterministic out: parity(Min, Even, ·), at most one mark on a branch; no letter gains a branch.
// One state of effort per copy and per node of the decomposition.
Branching paritise(const Branching& automaton, Effort& effort);

}  // namespace waymark::automata
