// 𝓜 ⊗ 𝒜_φ of a hallway map, reachable part only. The label of the start pose is read, always (conventions.md 1).
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/product/discovery_order.hpp"
#include "libplan/product/task_steps.hpp"

namespace waymark::plan {

// The product that routes are searched on, with its reachable pairs numbered breadth first; Boost.Graph's
// IncidenceGraph and VertexListGraph. Out-edges are in action order FORWARD, LEFT, RIGHT. Traps of the automaton are
// vertices without out-edges.
class MapProduct : public Product<MapMdp, TaskSteps> {
 public:
  // Map and automaton must outlive it. Throws ltl::FormatError naming a proposition that the map lacks. nullopt: more
  // vertices than the limit, or stopped. O(|S| · |Q|).
  static std::optional<MapProduct> explore(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                                           const ltl::Limits& limits);

  const Map& map() const { return task().map(); }                        // of the model
  const automata::Dfa& dfa() const { return task().dfa(); }              // of the task
  const std::vector<ProductState>& starts() const { return starts_; }    // one for every start pose, in that order
  bool is_accepting(const ProductState& v) const { return is_goal(v); }  // may the route stop here?
  bool is_trap(const ProductState& v) const { return task().is_over(v.task); }  // is no accepting pair reachable?
  Action action(const ProductEdge& e) const { return model().move(e.from.place, e.choice); }  // of the edge
  std::uint32_t index(const ProductState& v) const { return order_.number(v); }  // in the order of vertices()

  using traversal_category = ListedProduct;
  using vertices_size_type = std::size_t;
  using vertex_iterator = std::vector<ProductState>::const_iterator;
  // What Boost.Graph asks of a graph with a list of vertices.
  friend std::pair<vertex_iterator, vertex_iterator> vertices(const MapProduct& g) {
    return {g.order_.states().begin(), g.order_.states().end()};
  }
  friend vertices_size_type num_vertices(const MapProduct& g) { return g.order_.states().size(); }
  // Of the reachable part.
  friend std::size_t num_edges(const MapProduct& g) {
    std::size_t edges = 0;
    for (const ProductState& v : g.order_.states()) edges += out_degree(v, g);
    return edges;
  }

 private:
  struct Parts {
    MapMdp model;
    TaskSteps task;
  };
  explicit MapProduct(std::shared_ptr<const Parts> parts)
      : Product(parts->model, parts->task),
        parts_(std::move(parts)),
        order_(parts_->model.states(), parts_->task.states()) {}

  std::shared_ptr<const Parts> parts_;
  std::vector<ProductState> starts_;
  DiscoveryOrder order_;
};

// `starts`: one pose, or several when the heading is unknown (conventions.md 8).
MapProduct compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts);
inline MapProduct compose(const Map& map, const automata::Dfa& dfa, PoseId start) {
  return compose(map, dfa, {&start, 1});
}
inline std::optional<MapProduct> compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                                         const ltl::Limits& limits) {
  return MapProduct::explore(map, dfa, starts, limits);
}

}  // namespace waymark::plan
