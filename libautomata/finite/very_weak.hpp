// Equivalent states of very weak automata (every cycle is a self-loop), in one bottom-up pass with hashing.
//
// The successors of q other than q already have their classes. q joins a class c in two cases. Either the root of c,
// with c replaced by a placeholder, equals the root of q with q replaced by the placeholder. Or c is the successor
// class of q that reaches all its other successors, and root(q)[q := c] = root(c). Otherwise q is a new class. The idea
// is [Rev92] for acyclic automata; self-loops are ours: if q ≡ c and c is no successor of q, the first case finds c; if
// c is a successor, all other successors of q are successors of c, so c is the unique successor of greatest height.
#pragma once
#include <optional>
#include <vector>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/graph/scc.hpp"

namespace waymark::automata {

struct Partition {
  std::vector<std::uint32_t> class_of;  // by state
  std::uint32_t classes = 0;            // how many
  Mtbdd diagram;                        // terminals are classes; what the roots do not reach is garbage
  std::vector<Mtbdd::Node> roots;       // by class: δ of its states
};

// nullopt when some component holds two states. O(vertices) expected.
std::optional<Partition> very_weak_partition(const Transitions& automaton, const TransitionGraph& graph);

}  // namespace waymark::automata
