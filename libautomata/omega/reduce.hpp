// Reduction of generalised Büchi automata: components and simulation in both directions, until nothing changes. The
// cheapest step that helps goes first: states are merged, then branches pruned, then both are tried with other marks.
#pragma once
#include "libautomata/effort.hpp"
#include "libautomata/omega/branching.hpp"
#include "libautomata/omega/scc_filter.hpp"

namespace waymark::automata {

struct Reduced {
  Branching automaton;
  bool complete = true;  // false: the effort ran out; the automaton is valid, and larger than it could be
};

// Never throws Spent except when stopped: what was reached is returned.
Reduced reduce(Branching automaton, MarksOn marks, Effort& effort);

}  // namespace waymark::automata
