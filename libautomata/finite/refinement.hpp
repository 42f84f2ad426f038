// The coarsest partition that acceptance and letters respect, by refinement with a worklist.
//
// As in [Hop71], when a class splits its largest part keeps the name, so a state is renamed O(log |Q|) times. In place
// of letters every decision node remembers its image over the current classes: only the nodes above renamed terminals
// are redone, and they stop where the image stays the same. A state's signature is the image of its root. While a good
// part of the states is renamed at a time, one pass over all nodes takes the place of looking for those above them.
#pragma once
#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/very_weak.hpp"

namespace waymark::automata {

// One step of budget per image redone.
Partition coarsest_partition(const Transitions& automaton, const TransitionGraph& graph, Budget& budget);

}  // namespace waymark::automata
