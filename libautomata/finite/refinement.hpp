// The coarsest partition that acceptance and letters respect, by partition refinement with a worklist.
//
// As in [Hop71], the largest part of a split class keeps its name, so a state is renamed O(log |Q|) times. Instead of
// letters, every decision node stores its image over the current classes. Only nodes above renamed terminals are
// recomputed, and recomputation stops where an image stays the same. The signature of a state is the image of its root.
// While many states are renamed at once, one pass over all nodes replaces the search for the nodes above them.
#pragma once
#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/very_weak.hpp"

namespace waymark::automata {

// One step of budget per image redone.
Partition coarsest_partition(const Transitions& automaton, const TransitionGraph& graph, Budget& budget);

}  // namespace waymark::automata
