#include "libautomata/deterministic/branch_colouring.hpp"

#include <algorithm>
#include <span>

#include "libautomata/graph/scc.hpp"
#include "libautomata/omega/acceptance.hpp"

namespace waymark::automata {
namespace {

class Graph {  // of the edges with at least a colour
 public:
  Graph(const std::vector<ProductEdge>& edges, std::uint32_t least) {
    std::uint32_t size = 0;
    for (const ProductEdge& e : edges) size = std::max({size, e.source + 1, e.target + 1});
    begin_.reserve(size + 1);
    targets_.reserve(edges.size());
    std::vector<std::uint32_t> last(size, UINT32_MAX);  // by target: the source of its last edge; once is enough
    for (const ProductEdge& e : edges) {
      if (e.colour < least || last[e.target] == e.source) continue;
      last[e.target] = e.source;
      while (begin_.size() <= e.source) begin_.push_back(static_cast<std::uint32_t>(targets_.size()));
      targets_.push_back(e.target);
    }
    begin_.resize(size + 1, static_cast<std::uint32_t>(targets_.size()));
  }
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> successors(std::uint32_t v) const {
    return {targets_.data() + begin_[v], begin_[v + 1] - begin_[v]};
  }

 private:
  std::vector<std::uint32_t> begin_, targets_;
};

}  // namespace

// Marks the branches of the edges, sources ascending, that lie on a cycle whose least colour has this parity.
std::vector<bool> BranchColouring::on_cycles(const std::vector<ProductEdge>& edges, std::uint32_t parity) const {
  std::vector<bool> out(branches_, false);
  for (std::uint32_t least = parity; least <= sets_; least += 2) {
    budget_.step(edges.size());
    if (std::none_of(edges.begin(), edges.end(), [&](const ProductEdge& e) { return e.colour == least; })) continue;
    const Components found = components(Graph(edges, least));
    const auto inside = [&](const ProductEdge& e) {
      return e.colour >= least && found.of[e.source] == found.of[e.target];
    };
    std::vector<bool> has_least(found.count, false);
    for (const ProductEdge& e : edges)
      if (e.colour == least && inside(e)) has_least[found.of[e.source]] = true;
    for (const ProductEdge& e : edges)
      if (inside(e) && has_least[found.of[e.source]]) out[e.branch] = true;
  }
  return out;
}

std::optional<BranchColouring::Colours> BranchColouring::colours(std::vector<ProductEdge> edges) const {
  Colours out(branches_, unset);
  std::uint32_t idle = 0;
  for (std::uint32_t colour = 0; !edges.empty(); ++colour) {
    if (colour + 3 > Marks::most || idle == 2) return std::nullopt;
    const std::vector<bool> blocked = on_cycles(edges, 1 - colour % 2);
    const auto coloured = [&](const ProductEdge& e) {
      if (!blocked[e.branch]) out[e.branch] = colour;
      return !blocked[e.branch];
    };
    idle = std::erase_if(edges, coloured) == 0 ? idle + 1 : 0;
  }
  return out;
}

}  // namespace waymark::automata
