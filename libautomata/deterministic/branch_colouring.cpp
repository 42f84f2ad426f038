#include "libautomata/deterministic/branch_colouring.hpp"

#include <algorithm>

#include "libautomata/omega/acceptance.hpp"

namespace waymark::automata {
namespace {

// Of edges whose sources ascend, those with at least a colour: the others lead back to where they begin.
struct Graph {
  const std::vector<ProductEdge>& edges;
  const std::vector<std::uint32_t>& begin;  // by vertex: its first edge; one more for the end
  std::uint32_t least;

  struct Targets {
    const ProductEdge* first;
    std::uint32_t count, least;
    std::size_t size() const { return count; }
    std::uint32_t operator[](std::size_t i) const {
      return first[i].colour >= least ? first[i].target : first[i].source;
    }
  };
  std::size_t size() const { return begin.size() - 1; }
  Targets successors(std::uint32_t v) const { return {edges.data() + begin[v], begin[v + 1] - begin[v], least}; }
};

// Where the edges of each vertex begin.
void index_sources(const std::vector<ProductEdge>& edges, std::uint32_t vertices, std::vector<std::uint32_t>& begin) {
  begin.resize(vertices + 1);
  std::uint32_t vertex = 0;
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    for (; vertex <= edges[i].source; ++vertex) begin[vertex] = i;
  for (; vertex <= vertices; ++vertex) begin[vertex] = static_cast<std::uint32_t>(edges.size());
}

}  // namespace

// Loops over edges compute their tests without a jump, which no processor could predict.
void BranchColouring::look_for_cycles(const std::vector<ProductEdge>& edges, std::uint32_t parity, Budget& budget) {
  blocked_.assign(branches_, 0);
  for (std::uint32_t least = parity; least <= sets_; least += 2) {
    budget.step(edges.size());
    if (std::none_of(edges.begin(), edges.end(), [&](const ProductEdge& e) { return e.colour == least; })) continue;
    search_.run(Graph{edges, begin_, least}, found_);
    const auto one = [](bool condition) { return condition ? 1U : 0U; };
    has_least_.assign(found_.count, 0);
    for (const ProductEdge& e : edges) {
      const std::uint32_t component = found_.of[e.source];
      has_least_[component] |= one(e.colour == least) & one(component == found_.of[e.target]);
    }
    for (const ProductEdge& e : edges) {
      const std::uint32_t component = found_.of[e.source];
      blocked_[e.branch] |= has_least_[component] & one(e.colour >= least) & one(component == found_.of[e.target]);
    }
  }
}

std::optional<BranchColouring::Colours> BranchColouring::colours(std::vector<ProductEdge>& edges, Budget& budget) {
  Colours out(branches_, unset);
  std::uint32_t vertices = 0;
  for (const ProductEdge& e : edges) vertices = std::max({vertices, e.source + 1, e.target + 1});
  for (std::uint32_t colour = 0; !edges.empty(); ++colour) {
    if (colour + 3 > Marks::most) return std::nullopt;
    index_sources(edges, vertices, begin_);
    look_for_cycles(edges, 1 - colour % 2, budget);
    const auto coloured = [&](const ProductEdge& e) {
      if (blocked_[e.branch] == 0) out[e.branch] = colour;
      return blocked_[e.branch] == 0;
    };
    // The cycles that blocked what is left consist of what is left: where nothing goes now, nothing will.
    if (std::erase_if(edges, coloured) == 0 && colour > 0) return std::nullopt;
  }
  return out;
}

}  // namespace waymark::automata
