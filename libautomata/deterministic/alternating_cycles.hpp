// The alternating cycle decomposition of an automaton [CCF21, Sec. 4], [CDMRS22]. The roots are the edge sets of the
// strongly connected components; children are the largest strongly connected subsets with the other acceptance, and so
// on.
//
// Ours: cycles are found as in the emptiness check, by removing marks under Fin, without a Zielonka tree. One operand
// of an unsatisfied conjunction names the marks to remove, so Rabin and Streett conditions branch only where necessary.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {

class AlternatingCycles {
 public:
  using Node = std::uint32_t;               // a number
  static constexpr Node none = UINT32_MAX;  // no node

  // Any condition. One step of budget per edge looked at; more levels than Marks::most count as too many states.
  AlternatingCycles(const TransitionRelation& automaton, Budget& budget);

  // Where a run stands that enters a component at q, none when q lies on no cycle: nodes are entered by their first
  // child that has q.
  Node entry(std::uint32_t q) const;
  struct Transition {
    Node node;             // none outside of cycles
    std::uint32_t colour;  // min even; `no_colour` when no cycle has the branch
  };
  static constexpr std::uint32_t no_colour = UINT32_MAX;  // of a branch between components
  // From q at a node over one of its branches: up to the node that has the branch, whose depth is the colour, and down
  // again by the child after the one that was left.
  Transition step(std::uint32_t q, Node at, const Branch& branch) const;
  std::uint32_t colours() const { return colours_; }

 private:
  using Edges = std::vector<std::uint32_t>;  // ascending
  struct Cycle {
    Node parent = none;
    std::uint32_t colour = 0;
    bool accepting = false;
    Edges edges;
    std::vector<std::uint32_t> states;  // ascending
    std::vector<Node> children;
  };

  bool has(Node node, std::uint32_t q) const;
  Node descend(Node node, std::uint32_t q) const;
  void grow(Node node, const Condition& condition, Budget& budget);
  Node add(Edges edges, Node parent, std::uint32_t colour, bool accepting);

  BranchGraph graph_;
  std::vector<std::uint32_t> first_edge_;  // by state
  std::vector<Branch> branch_;             // by edge
  std::vector<std::uint32_t> source_;      // by edge
  std::vector<Node> root_;                 // by state
  std::vector<Cycle> nodes_;
  std::uint32_t colours_ = 0;
};

}  // namespace waymark::automata
