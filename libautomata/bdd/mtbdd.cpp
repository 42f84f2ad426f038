#include "libautomata/bdd/mtbdd.hpp"

#include <stdexcept>

namespace waymark::automata {
namespace {

constexpr std::size_t initial_slots = 256;  // 1 KiB of unique table

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
  if (indexed_ != live() || table_.empty()) index();
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
  if (free_ != none) {
    const Node made{free_};
    free_ = nodes_[made.id].low.id;
    nodes_[made.id] = {variable, low, high};
    --swept_;
    refilled_ = true;
    return made;
  }
  if (nodes_.size() >= terminal_bit - 1) throw std::length_error("decision diagram with 2^31 nodes");
  nodes_.push_back({variable, low, high});
  return Node{static_cast<std::uint32_t>(nodes_.size() - 1)};
}

void Mtbdd::index() {
  std::size_t slots = std::max(initial_slots, table_.size());
  while (slots < 4 * live()) slots *= 2;
  table_.assign(slots, 0);
  for (std::uint32_t id = 0; id < nodes_.size(); ++id) {
    const Decision& d = nodes_[id];
    if (is_swept(id)) continue;
    std::size_t at = hash(d.variable, d.low, d.high) & (slots - 1);
    while (table_[at] != 0) at = (at + 1) & (slots - 1);
    table_[at] = id + 1;
  }
  indexed_ = live();
}

// Children have smaller ids: a scan down marks, a scan up lists. It reads memory in order, which on large diagrams is
// several times as fast as following edges.
std::vector<Mtbdd::Node> Mtbdd::reachable_by_id(std::span<const Node> roots) const {
  std::vector<bool> marked(nodes_.size(), false);
  const auto mark = [&](Node n) {
    if (!is_terminal(n)) marked[n.id] = true;
  };
  for (const Node root : roots) mark(root);
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

std::vector<Mtbdd::Node> Mtbdd::reachable(std::span<const Node> roots) const {
  if (!refilled_) return reachable_by_id(roots);
  std::vector<bool> seen(nodes_.size(), false);
  std::vector<Node> out;
  const auto visit = [&](auto&& self, Node n) -> void {
    if (is_terminal(n) || seen[n.id]) return;
    seen[n.id] = true;
    self(self, low(n));
    self(self, high(n));
    out.push_back(n);
  };
  for (const Node root : roots) visit(visit, root);
  return out;
}

void Mtbdd::collect(std::span<const Node> roots) {
  std::vector<bool> marked(nodes_.size(), false);
  for (const Node n : reachable(roots)) marked[n.id] = true;
  free_ = none;
  swept_ = 0;
  for (auto id = static_cast<std::uint32_t>(nodes_.size()); id-- > 0;) {
    if (marked[id]) continue;
    nodes_[id] = {no_variable, Node{free_}, {}};
    free_ = id;
    ++swept_;
  }
  table_.clear();
  indexed_ = 0;
  results_.forget();
}

}  // namespace waymark::automata
