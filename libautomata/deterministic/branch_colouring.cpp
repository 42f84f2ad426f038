#include "libautomata/deterministic/branch_colouring.hpp"

#include <algorithm>
#include <span>

#include "libautomata/graph/scc.hpp"
#include "libautomata/omega/acceptance.hpp"

namespace waymark::automata {
namespace {

class Graph {  // of the edges with at least a colour
 public:
  Graph(const std::vector<ProductEdge>& edges, std::uint32_t least, std::uint32_t size)
      : begin_(size + 1), targets_(edges.size()) {
    std::vector<std::uint32_t> last(size, UINT32_MAX);  // by target: the source of its last edge; once is enough
    std::uint32_t count = 0, source = 0;
    for (const ProductEdge& e : edges) {
      for (; source < e.source; ++source) begin_[source + 1] = count;
      const bool kept = e.colour >= least && last[e.target] != e.source;
      last[e.target] = kept ? e.source : last[e.target];
      targets_[count] = e.target;
      count += kept ? 1 : 0;
    }
    for (; source < size; ++source) begin_[source + 1] = count;
  }
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> successors(std::uint32_t v) const {
    return {targets_.data() + begin_[v], begin_[v + 1] - begin_[v]};
  }

 private:
  std::vector<std::uint32_t> begin_, targets_;
};

}  // namespace

// By branch: 1 when one of its edges, sources ascending, is on a cycle whose least colour has this parity. Loops over
// edges compute their tests without a jump, which no processor could predict.
std::vector<std::uint32_t> BranchColouring::on_cycles(const std::vector<ProductEdge>& edges,
                                                      std::uint32_t parity) const {
  std::vector<std::uint32_t> out(branches_);
  std::uint32_t size = 0;
  for (const ProductEdge& e : edges) size = std::max({size, e.source + 1, e.target + 1});
  for (std::uint32_t least = parity; least <= sets_; least += 2) {
    budget_.step(edges.size());
    if (std::none_of(edges.begin(), edges.end(), [&](const ProductEdge& e) { return e.colour == least; })) continue;
    const Components found = components(Graph(edges, least, size));
    const auto one = [](bool condition) { return condition ? 1U : 0U; };
    std::vector<std::uint32_t> has_least(found.count);
    for (const ProductEdge& e : edges) {
      const std::uint32_t component = found.of[e.source];
      has_least[component] |= one(e.colour == least) & one(component == found.of[e.target]);
    }
    for (const ProductEdge& e : edges) {
      const std::uint32_t component = found.of[e.source];
      out[e.branch] |= has_least[component] & one(e.colour >= least) & one(component == found.of[e.target]);
    }
  }
  return out;
}

std::optional<BranchColouring::Colours> BranchColouring::colours(std::vector<ProductEdge>& edges) const {
  Colours out(branches_, unset);
  std::uint32_t idle = 0;
  for (std::uint32_t colour = 0; !edges.empty(); ++colour) {
    if (colour + 3 > Marks::most || idle == 2) return std::nullopt;
    const std::vector<std::uint32_t> blocked = on_cycles(edges, 1 - colour % 2);
    const auto coloured = [&](const ProductEdge& e) {
      if (blocked[e.branch] == 0) out[e.branch] = colour;
      return blocked[e.branch] == 0;
    };
    idle = std::erase_if(edges, coloured) == 0 ? idle + 1 : 0;
  }
  return out;
}

}  // namespace waymark::automata
