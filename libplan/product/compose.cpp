#include "libplan/product/compose.hpp"

#include <unordered_map>

#include "libplan/product/task_steps.hpp"

namespace waymark::plan {
namespace {

class Composer {
 public:
  Composer(Product& product, const CompositionLimits& limits)
      : steps_(*product.map, *product.dfa), product_(product), limits_(limits) {}

  bool run(std::span<const PoseId> starts) {  // false: a limit was met
    for (PoseId s : starts)
      product_.starts.push_back(vertex({s, steps_.next(product_.dfa->initial(), product_.map->label_id(s))}));
    for (ProductVertex v = 0; v < num_vertices(product_.graph); ++v) {  // grows while we look: breadth first
      if (!product_.is_trap(v)) expand(v);
      if (num_vertices(product_.graph) > limits_.vertices) return false;
      if (v % polling_interval == 0 && limits_.stop.stop_requested()) return false;
    }
    return true;
  }

 private:
  static constexpr ProductVertex polling_interval = 256;

  ProductVertex vertex(const ProductState& state) {
    const std::uint64_t key = std::uint64_t{state.task.index} << 32U | state.pose.index;
    const auto [it, is_new] = vertices_.try_emplace(key, num_vertices(product_.graph));
    if (is_new) add_vertex(state, product_.graph);
    return it->second;
  }

  void expand(ProductVertex v) {
    const ProductState from = product_.graph[v];
    for (Action action : all_actions) {
      const auto pose = product_.map->successor(from.pose, action);
      if (!pose) continue;
      const ProductVertex to =
          vertex({*pose, steps_.next(from.task, product_.map->letter_id(*pose, action))});
      add_edge(v, to, ProductEdge{action, product_.map->cost(action)}, product_.graph);
    }
  }

  TaskSteps steps_;
  Product& product_;  // built in place: Boost copies graphs, it does not move
  const CompositionLimits& limits_;
  std::unordered_map<std::uint64_t, ProductVertex> vertices_;  // pair → vertex
};

}  // namespace

Product compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts) {
  Product product{&map, &dfa, {}, {}};
  const CompositionLimits none;
  Composer(product, none).run(starts);
  return product;
}

std::optional<Product> compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                               const CompositionLimits& limits) {
  std::optional<Product> product(Product{&map, &dfa, {}, {}});
  if (!Composer(*product, limits).run(starts)) product.reset();
  return product;
}

}  // namespace waymark::plan
