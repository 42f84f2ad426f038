#include "libplan/roads/road_shortcuts.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace waymark::plan {
namespace {

// The cheapest arc from u to v, where there is one.
std::optional<std::uint32_t> cheapest(const RoadGraph& graph, std::uint32_t u, std::uint32_t v) {
  std::optional<std::uint32_t> out;
  for (const RoadGraph::Arc& arc : graph.arcs(u))
    if (arc.to == v && (!out || arc.cost < *out)) out = arc.cost;
  return out;
}

// visit(v, cost): of every v ≠ u with an arc from u, the cheapest arc, once.
template <class Visit>
void for_each_road(const RoadGraph& graph, std::uint32_t u, const Visit& visit) {
  const auto arcs = graph.arcs(u);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto same = [&](const RoadGraph::Arc& arc) { return arc.to == arcs[i].to; };
    const auto before = arcs.first(i);
    if (arcs[i].to == u || std::any_of(before.begin(), before.end(), same)) continue;
    visit(arcs[i].to, *cheapest(graph, u, arcs[i].to));
  }
}

}  // namespace

std::uint16_t LetterSets::known(std::uint64_t set) {
  const auto [found, fresh] = numbers_.try_emplace(set, static_cast<std::uint16_t>(sets_.size()));
  if (!fresh) return found->second;
  if (sets_.size() > UINT16_MAX) throw std::invalid_argument("shortcuts pass over more than 65,536 sets of letters");
  sets_.push_back(set);
  return found->second;
}

RemainingRoads::RemainingRoads(const RoadGraph& graph) : rows_(graph.nodes()) {
  // A record at u for every road out of u, and one for every road into u that is no way back of the same cost.
  for (std::uint32_t u = 0; u < graph.nodes(); ++u)
    for_each_road(graph, u, [&](std::uint32_t v, std::uint32_t cost) {
      if (rows_[u].capacity == most_degree || rows_[v].capacity == most_degree)
        throw std::invalid_argument("a node with more than 32,767 roads");
      ++rows_[u].capacity;
      if (cheapest(graph, v, u) != cost) ++rows_[v].capacity;
    });
  std::size_t size = 0;
  for (Row& row : rows_) {
    row.begin = static_cast<std::uint32_t>(size);
    size += row.capacity;
    if (size > UINT32_MAX / 2) throw std::invalid_argument("too many roads for a hierarchy");
  }
  pool_.reserve(size + size / 3);
  pool_.resize(size);
  for (std::uint32_t u = 0; u < graph.nodes(); ++u)
    for_each_road(graph, u, [&](std::uint32_t v, std::uint32_t cost) {
      const bool both = cheapest(graph, v, u) == cost;
      append(u, {v, cost, RoadHierarchy::road, 0,
                 static_cast<std::uint16_t>(both ? RoadHierarchy::forward | RoadHierarchy::backward
                                                 : RoadHierarchy::forward)});
      if (!both) append(v, {u, cost, RoadHierarchy::road, 0, RoadHierarchy::backward});
    });
}

void RemainingRoads::append(std::uint32_t node, const Arc& arc) {
  Row& row = rows_[node];
  if (row.size == row.capacity) grow(row);
  pool_[row.begin + row.size++] = arc;
}

void RemainingRoads::grow(Row& row) {
  if (row.capacity >= most_degree) throw std::invalid_argument("a node of the hierarchy with too many shortcuts");
  const auto capacity = static_cast<std::uint16_t>(row.capacity + std::max(1, row.capacity / 2));
  if (free_.size() <= capacity) free_.resize(capacity + 1U);
  std::uint32_t begin = 0;
  if (!free_[capacity].empty()) {
    begin = free_[capacity].back();
    free_[capacity].pop_back();
  } else {
    if (pool_.size() > UINT32_MAX - capacity) throw std::invalid_argument("too many shortcuts for a hierarchy");
    begin = static_cast<std::uint32_t>(pool_.size());
    pool_.resize(pool_.size() + capacity);
  }
  std::copy_n(pool_.begin() + row.begin, row.size, pool_.begin() + begin);
  if (row.capacity > 0) free_[row.capacity].push_back(row.begin);
  row = {begin, row.size, capacity};
}

// The other record of an arc at u. What distinguishes parallel arcs is the same at both ends.
RemainingRoads::Arc* RemainingRoads::mirror(std::uint32_t u, const Arc& arc) {
  const Row& row = rows_[arc.head];
  for (Arc* a = pool_.data() + row.begin; a != pool_.data() + row.begin + row.size; ++a)
    if (a->head == u && a->cost == arc.cost && a->middle == arc.middle && a->passed == arc.passed) return a;
  throw std::logic_error("an arc that is known at one end only");
}

void RemainingRoads::erase(std::uint32_t node, const Arc* arc) {
  Row& row = rows_[node];
  pool_[static_cast<std::size_t>(arc - pool_.data())] = pool_[row.begin + --row.size];
}

void RemainingRoads::add(std::uint32_t u, const Arc& arc) {
  std::uint16_t ways = arc.ways;
  for (const Arc& known : arcs(u))
    if (known.head == arc.head && known.cost <= arc.cost && sets_.contains(arc.passed, known.passed))
      ways = static_cast<std::uint16_t>(ways & ~known.ways);
  if (ways == 0) return;
  Arc* same = nullptr;
  for (std::uint16_t i = 0; i < rows_[u].size;) {
    Arc& known = pool_[rows_[u].begin + i++];
    if (known.head != arc.head) continue;
    if (known.cost == arc.cost && known.middle == arc.middle && known.passed == arc.passed) {
      same = &known;
      continue;
    }
    if ((known.ways & ways) == 0 || known.cost < arc.cost || !sets_.contains(known.passed, arc.passed)) continue;
    Arc* other = mirror(u, known);
    known.ways = static_cast<std::uint16_t>(known.ways & ~ways);
    other->ways = turned(known.ways);
    if (known.ways != 0) continue;
    erase(known.head, other);
    if (same == &pool_[rows_[u].begin + rows_[u].size - 1U]) same = &known;  // which erase moves here
    erase(u, &known);
    --i;
  }
  if (same != nullptr) {
    Arc* other = mirror(u, *same);
    same->ways = static_cast<std::uint16_t>(same->ways | ways);
    other->ways = turned(same->ways);
    return;
  }
  Arc added = arc;
  added.ways = ways;
  append(u, added);
  added.head = u;
  added.ways = turned(ways);
  append(arc.head, added);
}

void RemainingRoads::detach(std::uint32_t node) {
  for (const Arc& arc : arcs(node)) {
    const Row& row = rows_[arc.head];
    for (std::uint16_t i = 0; i < row.size;) {
      const Arc& back = pool_[row.begin + i];
      if (back.head == node)
        erase(arc.head, &back);
      else
        ++i;
    }
  }
}

}  // namespace waymark::plan
