#include "libplan/solve/least_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "libautomata/graph/scc.hpp"

namespace waymark::plan {

using automata::Marks;

AcceptingPart::AcceptingPart(const MarkedGraph& graph) {
  struct Successors {
    std::vector<std::vector<std::uint32_t>> targets;
    std::size_t size() const { return targets.size(); }
    const std::vector<std::uint32_t>& successors(std::uint32_t v) const { return targets[v]; }
  } plain{std::vector<std::vector<std::uint32_t>>(graph.vertices())};
  for (const MarkedEdge& e : graph.edges) plain.targets[e.from].push_back(e.to);
  automata::Components found = automata::components(plain);
  std::vector<Marks> met(found.count);
  std::vector<bool> cyclic(found.count, false);
  for (const MarkedEdge& e : graph.edges) {
    const std::uint32_t c = found.of[e.from];
    if (c != found.of[e.to]) continue;
    met[c] = met[c] | e.marks;
    cyclic[c] = true;
  }
  for (std::uint32_t c = 0; c < found.count; ++c) accepting_.push_back(cyclic[c] && met[c].includes(graph.all()));
  component_ = std::move(found.of);
}

double cost_of(const MarkedGraph& graph, const std::vector<std::uint32_t>& edges) {
  double cost = 0;
  for (std::uint32_t e : edges) cost += graph.edges[e].cost;
  return cost;
}

LeastCycles::LeastCycles(const MarkedGraph& graph, const AcceptingPart& part, automata::Budget& budget)
    : graph_(graph), part_(part), budget_(budget) {
  const std::uint64_t size = graph.sets < 32 ? std::uint64_t{graph.vertices()} << graph.sets : UINT64_MAX;
  if (size >= none) throw automata::Budget::Exceeded{automata::Budget::Exceeded::Reason::States};
  for (std::uint64_t i = graph.vertices(); i < size; ++i) budget.state();
  distance_.assign(size, INFINITY);
  best_.resize(size);
}

void LeastCycles::reset() {
  for (std::uint32_t node : touched_) distance_[node] = INFINITY;
  touched_.clear();
  relaxations_.clear();
  heap_.clear();
}

void LeastCycles::relax(std::uint32_t from, std::uint32_t edge, Marks met, double cost) {
  const MarkedEdge& e = graph_.edges[edge];
  if (!part_.keeps(e)) return;
  budget_.step();
  const std::uint32_t to = layered(e.to, met | (e.marks & graph_.all()));
  if (cost > distance_[to]) return;
  relaxations_.push_back({from, edge, to});
  if (cost == distance_[to]) return;
  if (std::isinf(distance_[to])) touched_.push_back(to);
  distance_[to] = cost;
  best_[to] = relaxations_.back();
  heap_.push_back({cost, to});
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void LeastCycles::expand(std::uint32_t node, double cost) {
  const std::uint32_t v = node >> graph_.sets;
  const Marks met = Marks::from_bits(node & graph_.all().bits());
  for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e)
    relax(node, e, met, cost + graph_.edges[e].cost);
}

double LeastCycles::through(std::uint32_t v, double most) {
  reset();
  target_ = layered(v, graph_.all());
  for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e) relax(none, e, Marks(), graph_.edges[e].cost);
  while (!heap_.empty()) {
    const auto [cost, node] = heap_.front();
    if (cost > std::min(most, distance_[target_])) break;  // whatever costs as much as the answer is expanded
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
    if (cost == distance_[node] && node != target_) expand(node, cost);
  }
  return distance_[target_] <= most ? distance_[target_] : INFINITY;
}

void LeastCycles::append_tree(std::uint32_t node, std::vector<std::uint32_t>& edges) const {
  std::vector<std::uint32_t> reversed;
  for (; node != none; node = best_[node].from) reversed.push_back(best_[node].edge);
  edges.insert(edges.end(), reversed.rbegin(), reversed.rend());
}

Cycle LeastCycles::walk() const {
  Cycle out;
  append_tree(target_, out.edges);
  out.cost = cost_of(graph_, out.edges);
  return out;
}

// Backwards from the target along relaxations that attain the distances: what is met lies on a walk of least cost, and
// the way on from there and the tree's way to it are the two halves of one.
Cycle LeastCycles::walk_entered_nearest(const std::vector<double>& distance) const {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> into;  // layered vertex → relaxations
  for (std::uint32_t i = 0; i < relaxations_.size(); ++i) {
    const Relaxation& r = relaxations_[i];
    const double before = r.from == none ? 0 : distance_[r.from];
    if (before + graph_.edges[r.edge].cost == distance_[r.to]) into[r.to].push_back(i);
  }
  std::unordered_map<std::uint32_t, std::uint32_t> onward;  // layered vertex → relaxation
  std::vector<std::uint32_t> queue{target_};
  std::uint32_t entry = target_;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t here = queue[i] >> graph_.sets, nearest = entry >> graph_.sets;
    if (distance[here] < distance[nearest]) entry = queue[i];
    for (std::uint32_t r : into[queue[i]]) {
      const std::uint32_t from = relaxations_[r].from;
      if (from != none && from != target_ && onward.try_emplace(from, r).second) queue.push_back(from);
    }
  }
  Cycle out;
  for (std::uint32_t node = entry; node != target_; node = relaxations_[onward.at(node)].to)
    out.edges.push_back(relaxations_[onward.at(node)].edge);
  append_tree(entry, out.edges);
  out.cost = cost_of(graph_, out.edges);
  return out;
}

}  // namespace waymark::plan
