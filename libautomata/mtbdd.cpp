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

std::uint64_t hash(Mtbdd::Variable variable, Mtbdd::Node low, Mtbdd::Node high) {
  return mix(mix(std::uint64_t{low.id} << 32U | high.id, 0), variable);
}

}  // namespace

Mtbdd::Node Mtbdd::make(Variable variable, Node low, Node high) {
  if (low == high) return low;
  if (indexed_ != nodes_.size() || table_.empty()) index();
  std::size_t at = hash(variable, low, high) & (table_.size() - 1);
  for (; table_[at] != 0; at = (at + 1) & (table_.size() - 1)) {
    const Decision& d = nodes_[table_[at] - 1];
    if (d.variable == variable && d.low == low && d.high == high) return Node{table_[at] - 1};
  }
  const Node made = append(variable, low, high);
  table_[at] = made.id + 1;
  if (2 * ++indexed_ > table_.size()) index();
  return made;
}

Mtbdd::Node Mtbdd::append(Variable variable, Node low, Node high) {
  assert(low != high && variable < this->variable(low) && variable < this->variable(high));
  if (nodes_.size() >= terminal_bit - 1) throw std::length_error("decision diagram with 2^31 nodes");
  nodes_.push_back({variable, low, high});
  return Node{static_cast<std::uint32_t>(nodes_.size() - 1)};
}

void Mtbdd::index() {
  std::size_t slots = std::max(initial_slots, table_.size());
  while (slots < 4 * nodes_.size()) slots *= 2;
  table_.assign(slots, 0);
  for (std::uint32_t id = 0; id < nodes_.size(); ++id) {
    const Decision& d = nodes_[id];
    std::size_t at = hash(d.variable, d.low, d.high) & (slots - 1);
    while (table_[at] != 0) at = (at + 1) & (slots - 1);
    table_[at] = id + 1;
  }
  indexed_ = nodes_.size();
}

Mtbdd::Remembered& Mtbdd::slot(Operation op, const std::array<Node, 3>& args) {
  if (cache_.empty() || (2 * cache_.size() < nodes_.size() && cache_.size() < largest_cache)) grow_cache();
  const std::uint64_t key = mix(std::uint64_t{args[0].id} << 32U | args[1].id, 0);
  return cache_[mix(key, std::uint64_t{op.tag} << 32U | args[2].id) & (cache_.size() - 1)];
}

void Mtbdd::grow_cache() {
  std::size_t slots = initial_cache;
  while (slots < nodes_.size() && slots < largest_cache) slots *= 2;
  std::vector<Remembered> old(slots);
  old.swap(cache_);
  for (const Remembered& r : old)
    if (r.tag != 0) slot(Operation{r.tag}, r.args) = r;
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
