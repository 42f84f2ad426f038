// Closed walks of least cost that meet every mark of a graph.
//
// A walk from v is followed through (vertex, marks met so far) by Dijkstra [Dij59]: marks may come in any order, so
// the shortest round through several places is found as it is, not as an order of levels would have it.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libplan/product/buchi_product.hpp"

namespace waymark::plan {

// The edges that a run can take for ever and be accepted: inside strongly connected components that have every mark.
class AcceptingPart {
 public:
  explicit AcceptingPart(const MarkedGraph& graph);
  bool contains(std::uint32_t v) const { return accepting_[component_[v]]; }  // on some accepting cycle?
  // On some accepting cycle?
  bool keeps(const MarkedEdge& e) const { return component_[e.from] == component_[e.to] && contains(e.from); }

 private:
  std::vector<std::uint32_t> component_;
  std::vector<bool> accepting_;  // by component
};

struct Cycle {  // a closed walk
  std::vector<std::uint32_t>
      edges;        // of the graph, each beginning where the one before ends, and the first where the last ends
  double cost = 0;  // the sum
};
double cost_of(const MarkedGraph& graph, const std::vector<std::uint32_t>& edges);  // of a walk

class LeastCycles {  // searches that share their memory
 public:
  // Throws what the budget throws: a state for every (vertex, set of marks).
  LeastCycles(const MarkedGraph& graph, const AcceptingPart& part, automata::Budget& budget);

  // The least cost of a closed walk from v that meets every mark; ∞ when it is more than `most`.
  double through(std::uint32_t v, double most);
  // After a finite answer: the walk from v.
  Cycle walk() const;
  // … and of all walks of that cost through v, one from that vertex on it which is nearest by `distance`.
  Cycle walk_entered_nearest(const std::vector<double>& distance) const;

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Relaxation {
    std::uint32_t from, edge, to;  // layered vertices; from: none at the beginning
  };
  std::uint32_t layered(std::uint32_t v, automata::Marks met) const {
    return (v << graph_.sets) | static_cast<std::uint32_t>(met.bits());
  }
  void reset();
  void relax(std::uint32_t from, std::uint32_t edge, automata::Marks met, double cost);
  void expand(std::uint32_t node, double cost);
  void append_tree(std::uint32_t node, std::vector<std::uint32_t>& edges) const;  // from v to the node

  const MarkedGraph& graph_;
  const AcceptingPart& part_;
  automata::Budget& budget_;
  std::uint32_t target_ = none;
  std::vector<double> distance_;         // by layered vertex
  std::vector<Relaxation> best_;         // the last to lower it
  std::vector<std::uint32_t> touched_;   // whose distance is finite
  std::vector<Relaxation> relaxations_;  // all of them
  using Entry = std::pair<double, std::uint32_t>;
  std::vector<Entry> heap_;
};

}  // namespace waymark::plan
