#include "libplan/roads/road_legs.hpp"

#include <algorithm>
#include <functional>
#include <new>
#include <queue>
#include <stdexcept>

namespace waymark::plan {
namespace {

constexpr std::uint64_t nodes_between_polls = 1U << 14U;

using CostAndVisit = std::pair<std::uint64_t, std::uint32_t>;
using Heap = std::priority_queue<CostAndVisit, std::vector<CostAndVisit>, std::greater<>>;

}  // namespace

RoadLegs::RoadLegs(const RoadGraph& graph, const RoadHierarchy& hierarchy, std::stop_token stop)
    : graph_(graph),
      hierarchy_(hierarchy),
      stop_(std::move(stop)),
      slot_(static_cast<std::uint32_t*>(std::calloc(graph.nodes(), sizeof(std::uint32_t)))) {
  if (slot_ == nullptr) throw std::bad_alloc();
  if (hierarchy.nodes() != graph.nodes()) throw std::invalid_argument("a hierarchy of another map");
}

void RoadLegs::begin(std::vector<LegRole> role) {
  for (const Visited& v : visits_) slot_.get()[v.rank] = 0;
  visits_.clear();
  up_.clear();
  down_.clear();
  role_ = std::move(role);
  barriers_ = 0;
  for (std::size_t b = 0; b < hierarchy_.bits().size(); ++b)
    if (!passes(role_[hierarchy_.bits()[b]])) barriers_ |= std::uint64_t{1} << b;
}

std::uint32_t RoadLegs::meet(std::uint32_t rank, LegRole role) {
  std::uint32_t& slot = slot_.get()[rank];
  if (slot == 0) {
    visits_.emplace_back();
    visits_.back().rank = rank;
    visits_.back().passed = passes(role);
    visits_.back().leads = leads(role);
    slot = static_cast<std::uint32_t>(visits_.size());
    ++statistics_.met;
  }
  return slot - 1;
}

void RoadLegs::relax(std::uint32_t from, std::uint32_t to, std::uint64_t cost, std::uint32_t via) {
  Visited& v = visits_[to];
  if (cost >= v.cost) return;
  v.cost = cost;
  v.from = from;
  v.via = via;
}

void RoadLegs::add_source(std::uint32_t node, std::uint64_t cost, std::uint32_t entry) {
  const std::uint32_t rank = hierarchy_.rank(node);
  relax(none, meet(rank, role(rank)), cost, entry);
}

template <class Chosen>
std::size_t RoadLegs::count(const Chosen& chosen) const {
  std::size_t out = 0;
  for (std::uint32_t l = 0; l < role_.size(); ++l)
    if (chosen(role_[l])) out += graph_.count(LetterId{l});
  return out;
}

bool RoadLegs::run(std::uint64_t limit, std::uint32_t target) {
  if (visits_.empty()) return true;
  if (!passes(role_[0]) || count(passes) <= count(leads)) return cross_passed(limit);
  collect_up();
  collect_down(target);
  sweep_up();
  if (!cross_core(limit, target)) return false;
  sweep_down();
  return true;
}

// What can be reached upwards from the sources, below the core and on its border.
void RoadLegs::collect_up() {
  for (std::uint32_t i = 0; i < visits_.size(); ++i) {
    const Visited v = visits_[i];
    if (v.rank >= hierarchy_.core() || !v.passed) continue;
    up_.push_back(i);
    for (std::uint32_t a = hierarchy_.begin_arcs(v.rank); a < hierarchy_.end_arcs(v.rank); ++a) {
      const RoadHierarchy::Arc& arc = hierarchy_.arc(a);
      if (!usable(arc, RoadHierarchy::forward)) continue;
      if (const LegRole r = role(arc.head); r != LegRole::Closed) meet(arc.head, r);
    }
  }
  std::sort(up_.begin(), up_.end(), [&](auto a, auto b) { return visits_[a].rank < visits_[b].rank; });
}

// What reaches the nodes that lead on by arcs downwards.
void RoadLegs::collect_down(std::uint32_t target) {
  std::vector<std::uint32_t> open;
  std::vector<bool> seen;
  const auto take = [&](std::uint32_t visit) {
    if (seen.size() <= visit) seen.resize(visits_.size() + 1, false);
    if (seen[visit]) return;
    seen[visit] = true;
    if (visits_[visit].rank >= hierarchy_.core())
      visits_[visit].wanted = true;
    else
      open.push_back(visit);
  };
  const auto lead = [&](std::uint32_t node) { take(meet(hierarchy_.rank(node), role(hierarchy_.rank(node)))); };
  for (std::uint32_t l = 0; l < role_.size() && target == any; ++l) {
    if (!leads(role_[l])) continue;
    // Past a letter that may not be passed, a leg cannot have come from a node of the same letter.
    for (const std::uint32_t node : passes(role_[l]) ? graph_.nodes_of(LetterId{l}) : graph_.entrances_of(LetterId{l}))
      lead(node);
    if (l != 0) continue;
    for (std::uint32_t node = 0; node < graph_.nodes(); ++node)
      if (graph_.letter(node).index == 0) lead(node);
  }
  if (target != any) lead(target);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    down_.push_back(i);
    const std::uint32_t rank = visits_[i].rank;
    for (std::uint32_t a = hierarchy_.begin_arcs(rank); a < hierarchy_.end_arcs(rank); ++a) {
      const RoadHierarchy::Arc& arc = hierarchy_.arc(a);
      if (const LegRole r = role(arc.head); usable(arc, RoadHierarchy::backward) && passes(r)) take(meet(arc.head, r));
    }
  }
  std::sort(down_.begin(), down_.end(), [&](auto a, auto b) { return visits_[a].rank > visits_[b].rank; });
}

void RoadLegs::sweep_up() {
  for (const std::uint32_t i : up_) {
    const Visited v = visits_[i];
    if (v.cost == unreached) continue;
    for (std::uint32_t a = hierarchy_.begin_arcs(v.rank); a < hierarchy_.end_arcs(v.rank); ++a) {
      const RoadHierarchy::Arc& arc = hierarchy_.arc(a);
      ++statistics_.edges;
      if (usable(arc, RoadHierarchy::forward) && met(arc.head) != 0) relax(i, met(arc.head) - 1, v.cost + arc.cost, a);
    }
  }
}

// By Dijkstra from where the core was entered, until all that matters below is settled.
bool RoadLegs::cross_core(std::uint64_t limit, std::uint32_t target) {
  Heap heap;
  std::size_t wanted = 0;
  for (std::uint32_t i = 0; i < visits_.size(); ++i) {
    if (visits_[i].rank < hierarchy_.core()) continue;
    if (visits_[i].cost != unreached) heap.emplace(visits_[i].cost, i);
    if (visits_[i].wanted) ++wanted;
  }
  const std::uint32_t only = target == any ? any : hierarchy_.rank(target);
  for (std::uint64_t settled = 0; !heap.empty() && wanted > 0; ++settled) {
    if (settled % nodes_between_polls == 0 && stop_.stop_requested()) return false;
    const auto [cost, i] = heap.top();
    heap.pop();
    const Visited v = visits_[i];
    if (cost > v.cost) continue;
    if (cost >= limit) break;
    if (v.wanted) {
      visits_[i].wanted = false;
      --wanted;
    }
    if (!v.passed) continue;
    for (std::uint32_t a = hierarchy_.begin_arcs(v.rank); a < hierarchy_.end_arcs(v.rank); ++a) {
      const RoadHierarchy::Arc& arc = hierarchy_.arc(a);
      ++statistics_.edges;
      if (const std::uint32_t m = met(arc.head); m != 0 && cost + arc.cost >= visits_[m - 1].cost) continue;
      if (!usable(arc, RoadHierarchy::forward)) continue;
      const LegRole r = role(arc.head);
      if (r == LegRole::Closed || (r == LegRole::Leads && only != any && arc.head != only)) continue;
      const std::uint32_t to = meet(arc.head, r);
      relax(i, to, cost + arc.cost, a);
      heap.emplace(cost + arc.cost, to);
    }
  }
  return true;
}

void RoadLegs::sweep_down() {
  for (const std::uint32_t i : down_) {
    const std::uint32_t rank = visits_[i].rank;
    for (std::uint32_t a = hierarchy_.begin_arcs(rank); a < hierarchy_.end_arcs(rank); ++a) {
      const RoadHierarchy::Arc& arc = hierarchy_.arc(a);
      ++statistics_.edges;
      if (!usable(arc, RoadHierarchy::backward) || met(arc.head) == 0) continue;
      const std::uint32_t h = met(arc.head) - 1;
      if (visits_[h].passed && visits_[h].cost != unreached) relax(h, i, visits_[h].cost + arc.cost, a);
    }
  }
}

// Where few nodes may be passed, or none without a label, of which shortcuts do not tell: a plain Dijkstra among them,
// on the map.
bool RoadLegs::cross_passed(std::uint64_t limit) {
  Heap heap;
  for (std::uint32_t i = 0; i < visits_.size(); ++i) heap.emplace(visits_[i].cost, i);
  for (std::uint64_t settled = 0; !heap.empty(); ++settled) {
    if (settled % nodes_between_polls == 0 && stop_.stop_requested()) return false;
    const auto [cost, i] = heap.top();
    heap.pop();
    if (cost > visits_[i].cost || !visits_[i].passed) continue;
    if (cost >= limit) break;
    for (const RoadGraph::Arc& arc : graph_.arcs(hierarchy_.node(visits_[i].rank))) {
      ++statistics_.edges;
      const std::uint32_t head = hierarchy_.rank(arc.to);
      const LegRole r = role(head);
      if (r == LegRole::Closed) continue;
      const std::uint32_t to = meet(head, r);
      if (cost + arc.cost >= visits_[to].cost) continue;
      relax(i, to, cost + arc.cost, by_road);
      heap.emplace(cost + arc.cost, to);
    }
  }
  return true;
}

std::pair<std::uint32_t, std::vector<RoadLegs::Hop>> RoadLegs::leg(std::uint32_t node) const {
  std::vector<Hop> hops;
  std::uint32_t i = met(hierarchy_.rank(node)) - 1;
  for (; visits_[i].from != none; i = visits_[i].from)
    hops.push_back({visits_[visits_[i].from].rank, visits_[i].rank, visits_[i].via});
  std::reverse(hops.begin(), hops.end());
  return {visits_[i].via, std::move(hops)};
}

}  // namespace waymark::plan
