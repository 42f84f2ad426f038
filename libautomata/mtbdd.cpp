#include "libautomata/mtbdd.hpp"

#include <stdexcept>

namespace waymark::automata {
namespace {

constexpr std::size_t initial_slots = 256;       // 1 KiB of unique table
constexpr std::size_t initial_cache = 128;       // 2.5 KiB
constexpr std::size_t largest_cache = 1U << 22;  // 80 MiB, reached at eight million nodes

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  a = (a ^ b) * 0x9E37'79B9'7F4A'7C15ULL;
  return a ^ (a >> 32U);
}

}  // namespace

Mtbdd::Mtbdd() : table_(initial_slots, 0), cache_(initial_cache) {}

Mtbdd::Node Mtbdd::make(Variable variable, Node low, Node high) {
  if (low == high) return low;
  assert(variable < this->variable(low) && variable < this->variable(high));
  const std::uint64_t hash = mix(mix(variable, low.id), high.id);
  std::size_t at = hash & (table_.size() - 1);
  for (; table_[at] != 0; at = (at + 1) & (table_.size() - 1)) {
    const Decision& d = nodes_[table_[at] - 1];
    if (d.variable == variable && d.low == low && d.high == high) return Node{table_[at] - 1};
  }
  if (nodes_.size() >= terminal_bit - 1) throw std::length_error("decision diagram with 2^31 nodes");
  const Node made{static_cast<std::uint32_t>(nodes_.size())};
  nodes_.push_back({variable, low, high});
  table_[at] = made.id + 1;
  if (2 * nodes_.size() > table_.size()) grow();
  return made;
}

void Mtbdd::grow() {
  table_.assign(4 * table_.size(), 0);
  for (std::uint32_t id = 0; id < nodes_.size(); ++id) {
    const Decision& d = nodes_[id];
    std::size_t at = mix(mix(d.variable, d.low.id), d.high.id) & (table_.size() - 1);
    while (table_[at] != 0) at = (at + 1) & (table_.size() - 1);
    table_[at] = id + 1;
  }
  if (cache_.size() >= largest_cache) return;
  std::vector<Remembered> old(std::min(largest_cache, table_.size() / 2));
  old.swap(cache_);
  for (const Remembered& r : old)
    if (r.tag != 0) slot(Operation{r.tag}, r.args) = r;
}

Mtbdd::Remembered& Mtbdd::slot(Operation op, const std::array<Node, 3>& args) {
  const std::uint64_t hash = mix(mix(mix(op.tag, args[0].id), args[1].id), args[2].id);
  return cache_[hash & (cache_.size() - 1)];
}

std::vector<Mtbdd::Node> Mtbdd::reachable(std::span<const Node> roots) const {
  std::vector<bool> marked(nodes_.size(), false);
  const auto mark = [&](Node n) {
    if (!is_terminal(n)) marked[n.id] = true;
  };
  for (Node root : roots) mark(root);
  for (std::size_t id = nodes_.size(); id-- > 0;) {
    if (!marked[id]) continue;
    mark(nodes_[id].low);
    mark(nodes_[id].high);
  }
  std::vector<Node> out;
  for (std::uint32_t id = 0; id < nodes_.size(); ++id)
    if (marked[id]) out.push_back(Node{id});
  return out;
}

}  // namespace waymark::automata
