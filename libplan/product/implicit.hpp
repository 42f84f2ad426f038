// The product 𝓜 ⊗ 𝒜_φ that is never built: a Boost.Graph IncidenceGraph whose vertices come into being when a search
// first meets them. A search for one route touches a fraction of the product, and a learner asks for thousands.
//
// Vertices are numbered in order of discovery and keep their numbers from search to search. Traps and accepting pairs
// are not expanded: nothing is to be gained behind a trap, and a plan stops where it accepts.
#pragma once
#include <array>
#include <boost/graph/graph_traits.hpp>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "libplan/product/graph.hpp"
#include "libplan/product/task_steps.hpp"

namespace waymark::plan {

class ImplicitProduct {  // not for two threads at once: looking at an edge may make a vertex
 public:
  using Vertex = std::uint32_t;
  struct Edge {
    Vertex source = 0, target = 0;
    Action action = Action::Forward;
    double cost = 0;
    friend bool operator==(const Edge& a, const Edge& b) {
      return a.source == b.source && a.action == b.action;
    }
  };
  using EdgeIterator = const Edge*;

  explicit ImplicitProduct(TaskSteps& steps) : steps_(&steps), table_(initial_slots, free_slot) {}

  Vertex enter(PoseId start) const;  // (s, δ(q₀, L(s))): the label of the start pose is read, always
  const ProductState& operator[](Vertex v) const { return states_[v]; }
  std::size_t discovered() const { return states_.size(); }
  bool is_accepting(Vertex v) const { return steps_->dfa().is_accepting(states_[v].task); }

  // Valid until the next call of out_edges for a vertex not asked for before; in action order.
  std::pair<EdgeIterator, EdgeIterator> out_edges(Vertex v) const;

 private:
  static constexpr std::size_t initial_slots = 256;  // a power of two
  static constexpr Vertex free_slot = UINT32_MAX;
  struct Expansion {
    std::array<Edge, 3> edges;
    std::uint8_t count = 0;
    bool done = false;
  };
  Vertex intern(const ProductState& state) const;
  void grow_table() const;
  void expand(Vertex v) const;

  TaskSteps* steps_;
  mutable std::vector<ProductState> states_;   // by vertex
  mutable std::vector<Expansion> expansions_;  // by vertex
  mutable std::vector<Vertex> table_;          // open-addressed over vertices
};

// The IncidenceGraph functions of Boost.Graph.
inline std::pair<ImplicitProduct::EdgeIterator, ImplicitProduct::EdgeIterator> out_edges(
    ImplicitProduct::Vertex v, const ImplicitProduct& g) {
  return g.out_edges(v);
}
inline std::size_t out_degree(ImplicitProduct::Vertex v, const ImplicitProduct& g) {
  const auto [begin, end] = g.out_edges(v);
  return static_cast<std::size_t>(end - begin);
}
inline ImplicitProduct::Vertex source(const ImplicitProduct::Edge& e, const ImplicitProduct&) {
  return e.source;
}
inline ImplicitProduct::Vertex target(const ImplicitProduct::Edge& e, const ImplicitProduct&) {
  return e.target;
}

}  // namespace waymark::plan

namespace boost {
template <>
struct graph_traits<waymark::plan::ImplicitProduct> {
  using vertex_descriptor = waymark::plan::ImplicitProduct::Vertex;
  using edge_descriptor = waymark::plan::ImplicitProduct::Edge;
  using out_edge_iterator = waymark::plan::ImplicitProduct::EdgeIterator;
  using directed_category = directed_tag;
  using edge_parallel_category = allow_parallel_edge_tag;  // a map may lead two actions to one pair
  using traversal_category = incidence_graph_tag;
  using degree_size_type = std::size_t;
  static vertex_descriptor null_vertex() { return UINT32_MAX; }
};
}  // namespace boost
