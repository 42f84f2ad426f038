#include "libplan/product/implicit.hpp"

namespace waymark::plan {
namespace {

std::size_t hash(const ProductState& state) {
  std::uint64_t h = (std::uint64_t{state.task.index} << 32U | state.pose.index) * 0x9E3779B97F4A7C15ULL;
  return static_cast<std::size_t>(h ^ (h >> 32U));
}

}  // namespace

ImplicitProduct::Vertex ImplicitProduct::intern(const ProductState& state) const {
  std::size_t slot = hash(state) & (table_.size() - 1);
  while (table_[slot] != free_slot) {
    if (states_[table_[slot]] == state) return table_[slot];
    slot = (slot + 1) & (table_.size() - 1);
  }
  const auto vertex = static_cast<Vertex>(states_.size());
  table_[slot] = vertex;
  states_.push_back(state);
  expansions_.emplace_back();
  if (2 * states_.size() > table_.size()) grow_table();
  return vertex;
}

void ImplicitProduct::grow_table() const {
  std::vector<Vertex> larger(2 * table_.size(), free_slot);
  for (Vertex v = 0; v < states_.size(); ++v) {
    std::size_t slot = hash(states_[v]) & (larger.size() - 1);
    while (larger[slot] != free_slot) slot = (slot + 1) & (larger.size() - 1);
    larger[slot] = v;
  }
  table_ = std::move(larger);
}

ImplicitProduct::Vertex ImplicitProduct::enter(PoseId start) const {
  return intern({start, steps_->next(steps_->dfa().initial(), steps_->map().label_id(start))});
}

std::pair<ImplicitProduct::EdgeIterator, ImplicitProduct::EdgeIterator> ImplicitProduct::out_edges(
    Vertex v) const {
  if (!expansions_[v].done) expand(v);
  const Expansion& expansion = expansions_[v];
  return {expansion.edges.data(), expansion.edges.data() + expansion.count};
}

void ImplicitProduct::expand(Vertex v) const {
  const ProductState from = states_[v];
  Expansion expansion;
  expansion.done = true;
  const automata::Dfa& dfa = steps_->dfa();
  if (!dfa.is_trap(from.task) && !dfa.is_accepting(from.task)) {
    const Map& map = steps_->map();
    for (Action action : all_actions) {
      const auto pose = map.successor(from.pose, action);
      if (!pose) continue;
      const Vertex to = intern({*pose, steps_->next(from.task, map.letter_id(*pose, action))});
      expansion.edges[expansion.count++] = {v, to, action, map.cost(action)};
    }
  }
  expansions_[v] = expansion;
}

}  // namespace waymark::plan
