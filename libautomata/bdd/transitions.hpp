// The transition function of a deterministic automaton under construction, and its graph.
//
// The vertices of the graph are decision nodes and states. Edges lead from a state to its root and from a node to its
// two children; a terminal is the state that it names. The graph has no letters. Reachability questions (components,
// distances, traps) are linear in this shared graph, and not in the number of letters or cubes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/budget.hpp"

namespace waymark::automata {

struct Transitions {
  Mtbdd diagram;                   // terminals are state indices
  std::vector<Mtbdd::Node> roots;  // δ(q, ·)
  std::vector<bool> accepting;     // by state
  std::uint32_t initial = 0;       // the state where words begin
};

// Of a TransitionGraph: decision nodes first, children before parents, then states.
using Vertex = std::uint32_t;

class TransitionGraph {  // successors of nodes and states
 public:
  TransitionGraph(const Mtbdd& diagram, std::span<const Mtbdd::Node> roots);  // O(diagram.size() + states)

  std::size_t size() const { return targets_.size() - nodes_.size(); }
  std::size_t nodes() const { return nodes_.size(); }                                        // of decision nodes
  std::size_t states() const { return size() - nodes(); }                                    // of states
  bool is_state(Vertex v) const { return v >= nodes_.size(); }                               // or a decision node
  Mtbdd::Node node(Vertex v) const { return nodes_[v]; }                                     // of a node vertex
  std::uint32_t state(Vertex v) const { return v - static_cast<Vertex>(nodes_.size()); }     // of a state vertex
  Vertex of_state(std::uint32_t q) const { return static_cast<Vertex>(nodes_.size()) + q; }  // the vertex of a state
  Vertex root(std::uint32_t q) const { return targets_[2 * nodes_.size() + q]; }  // the vertex to which a state leads
  // {low, high} of a node; {root} of a state.
  std::span<const Vertex> successors(Vertex v) const {
    if (is_state(v)) return {&targets_[2 * nodes_.size() + state(v)], 1};
    return {&targets_[2 * std::size_t{v}], 2};
  }

 private:
  std::vector<Mtbdd::Node> nodes_;
  std::vector<Vertex> targets_;  // two per node, then one per state
};

// Edges turned round: predecessors of every vertex, in one array. O(vertices + edges).
class ReversedGraph {
 public:
  explicit ReversedGraph(const TransitionGraph& graph);
  std::span<const Vertex> predecessors(Vertex v) const {  // of a vertex
    return {sources_.data() + begin_[v], begin_[v + 1] - begin_[v]};
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<Vertex> sources_;
};

// The reachable states, numbered breadth first from the initial state, each state's targets in the order of its
// diagram (false before true); nodes made afresh in that order, so equal automata over equal variables give equal
// bytes. The initial state becomes 0. O(size), one step of budget per state.
Transitions canonical(const Transitions& automaton, Budget& budget);
inline Transitions canonical(const Transitions& automaton) {
  Budget unlimited;
  return canonical(automaton, unlimited);
}

}  // namespace waymark::automata
