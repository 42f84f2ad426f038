// Equivalent states of very weak automata (no cycle but self-loops), in one pass from the bottom with hashing.
//
// Below q everything has its class already. Two looks decide: is there a class whose root, itself replaced by a
// placeholder, equals q's root with q replaced by it? Or is q the same as the one successor class that reaches all
// its others? If neither, q is a new class. The idea is [Rev92] for acyclic automata; self-loops are our addition:
// if q ≡ c and c is no successor of q the first look finds it; if it is one, every other successor d of q is one of c,
// so c is the unique successor of greatest height, and q ≡ c iff root(q)[q := c] = root(c).
#pragma once
#include <optional>
#include <vector>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/graph/scc.hpp"

namespace waymark::automata {

struct Partition {
  std::vector<std::uint32_t> class_of;  // by state
  std::uint32_t classes = 0;
  Mtbdd diagram;                   // terminals are classes; what the roots do not reach is garbage
  std::vector<Mtbdd::Node> roots;  // by class: δ of its states
};

// nullopt when some component holds two states. O(vertices) expected.
std::optional<Partition> very_weak_partition(const Transitions& automaton, const TransitionGraph& graph);

}  // namespace waymark::automata
