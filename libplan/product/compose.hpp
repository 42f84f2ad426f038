// 𝓜 ⊗ 𝒜_φ, reachable part only. The label of the start pose is read, always (conventions.md 1).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "libplan/product/graph.hpp"

namespace waymark::plan {

struct Product {
  const Map* map;  // both must outlive the product
  const automata::Dfa* dfa;
  ProductGraph graph;                 // out-edges in action order FORWARD, LEFT, RIGHT
  std::vector<ProductVertex> starts;  // (s, δ(q₀, L(s))) for every start pose s, in the order given
  bool is_accepting(ProductVertex v) const { return dfa->is_accepting(graph[v].task); }
  bool is_trap(ProductVertex v) const { return dfa->is_trap(graph[v].task); }
};

// `starts`: one pose, or several when the heading is unknown (conventions.md 8). The DFA's propositions are matched
// with the map's by name; throws ltl::FormatError naming a proposition that the map lacks.
// Traps of the automaton are kept as vertices without out-edges. O(|S| · |Q|) vertices at most, in breadth-first order.
Product compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts);
inline Product compose(const Map& map, const automata::Dfa& dfa, PoseId start) {
  return compose(map, dfa, {&start, 1});
}

struct CompositionLimits {
  std::size_t vertices = SIZE_MAX;
  std::stop_token stop = {};  // polled every few hundred vertices
};
// The same, or nullopt when the product has more vertices than the limit, or when a stop was requested.
std::optional<Product> compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                               const CompositionLimits& limits);

}  // namespace waymark::plan
