#include "libplan/solve/mean_cycle.hpp"

#include <algorithm>
#include <optional>

#include "libautomata/graph/scc.hpp"

namespace waymark::plan {
namespace {

using automata::Marks;

constexpr std::uint32_t no_index = UINT32_MAX;

class RatioSearch {
 public:
  RatioSearch(const MarkedGraph& graph, const AcceptingPart& part, const Cycle& known, automata::Budget& budget)
      : graph_(graph),
        part_(part),
        budget_(budget),
        best_{known, rounds_of(graph, known.edges)},
        potential_(std::size_t{graph.vertices()} << graph.sets),
        parent_(potential_.size()) {
    for (const MarkedEdge& e : graph.edges) dearest_ = std::max(dearest_, e.cost);
  }

  MeanCycle run(const std::vector<double>& distance) {
    while (const auto better = negative_cycle()) {
      if (!(better->mean() < best_.mean())) break;
      best_ = *better;
    }
    return entered_nearest(distance);
  }

 private:
  struct LayeredEdge {  // a layered edge
    std::uint32_t from = no_index, edge = no_index, to = no_index;
    double weight = 0;  // cost · rounds of the best one − its cost a round: of the best one 0 in sum
    bool completes = false;
  };
  double scale() const { return static_cast<double>(best_.rounds) * dearest_ + best_.cycle.cost; }

  LayeredEdge step(std::uint32_t node, std::uint32_t edge) const {
    const MarkedEdge& e = graph_.edges[edge];
    Marks met = (Marks::from_bits(node & graph_.all().bits()) | e.marks) & graph_.all();
    const bool completes = met == graph_.all();
    if (completes) met = Marks();
    return {node, edge, (e.to << graph_.sets) | static_cast<std::uint32_t>(met.bits()),
            static_cast<double>(best_.rounds) * e.cost - (completes ? best_.cycle.cost : 0), completes};
  }
  template <class Visit>
  void for_each_step(std::uint32_t node, const Visit& visit) const {
    const std::uint32_t v = node >> graph_.sets;
    for (std::uint32_t e = graph_.first[v]; e < graph_.first[v + 1]; ++e)
      if (part_.keeps(graph_.edges[e])) visit(step(node, e));
  }
  std::uint32_t nodes() const { return static_cast<std::uint32_t>(potential_.size()); }

  // Relaxes until nothing changes or the last steps into each node close a circle: that one is negative.
  std::optional<MeanCycle> negative_cycle() {
    std::fill(potential_.begin(), potential_.end(), 0.0);
    std::fill(parent_.begin(), parent_.end(), LayeredEdge{});
    const double slack = 1e-12 * scale();
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t node = 0; node < nodes(); ++node) {
        budget_.step();
        for_each_step(node, [&](const LayeredEdge& s) {
          if (!(potential_[node] + s.weight < potential_[s.to] - slack)) return;
          potential_[s.to] = potential_[node] + s.weight;
          parent_[s.to] = s;
          changed = true;
        });
      }
      if (const std::uint32_t node = on_circle(); node != no_index) return circle(node);
    }
    return std::nullopt;
  }

  // A node on a circle of parents.
  std::uint32_t on_circle() const {
    std::vector<std::uint32_t> seen(nodes(), no_index);  // in the walk from which node
    for (std::uint32_t first = 0; first < nodes(); ++first)
      for (std::uint32_t node = first; seen[node] == no_index; node = parent_[node].from) {
        seen[node] = first;
        const std::uint32_t next = parent_[node].from;
        if (next == no_index) break;
        if (seen[next] == first) return next;
      }
    return no_index;
  }
  MeanCycle circle(std::uint32_t first) const {
    std::vector<LayeredEdge> steps;
    for (std::uint32_t node = first; steps.empty() || node != first; node = parent_[node].from)
      steps.push_back(parent_[node]);
    std::reverse(steps.begin(), steps.end());
    return measured(steps);
  }
  MeanCycle measured(const std::vector<LayeredEdge>& steps) const {
    MeanCycle out{{}, 0};
    for (const LayeredEdge& s : steps) {
      out.cycle.edges.push_back(s.edge);
      out.rounds += s.completes ? 1 : 0;
    }
    out.cycle.cost = cost_of(graph_, out.cycle.edges);
    return out;
  }

  // Under the potentials of the least ratio no step is negative, and the cycles of that ratio are those of steps that
  // come to nothing.
  MeanCycle entered_nearest(const std::vector<double>& distance) const {
    struct Tight {
      std::vector<std::vector<std::uint32_t>> targets;
      std::size_t size() const { return targets.size(); }
      const std::vector<std::uint32_t>& successors(std::uint32_t v) const { return targets[v]; }
    } graph{std::vector<std::vector<std::uint32_t>>(nodes())};
    std::vector<LayeredEdge> completing;
    for (std::uint32_t node = 0; node < nodes(); ++node)
      for_each_step(node, [&](const LayeredEdge& s) {
        if (!is_tight(s)) return;
        graph.targets[node].push_back(s.to);
        if (s.completes) completing.push_back(s);
      });
    const automata::Components found = automata::components(graph);
    std::vector<bool> wanted(found.count, false);
    for (const LayeredEdge& s : completing)
      if (found.of[s.from] == found.of[s.to]) wanted[found.of[s.from]] = true;
    std::uint32_t entry = no_index;
    for (std::uint32_t node = 0; node < nodes(); ++node)
      if (wanted[found.of[node]] &&
          (entry == no_index || distance[node >> graph_.sets] < distance[entry >> graph_.sets]))
        entry = node;
    if (entry == no_index) return best_;
    const MeanCycle nearest = measured(shortest_circle(entry, found));
    return nearest.mean() <= best_.mean() ? nearest : best_;
  }
  bool is_tight(const LayeredEdge& s) const {
    return potential_[s.from] + s.weight <= potential_[s.to] + 1e-9 * scale();
  }

  // Through tight steps of the component, past one that completes a round; fewest steps.
  std::vector<LayeredEdge> shortest_circle(std::uint32_t entry, const automata::Components& components) const {
    std::vector<LayeredEdge> by(2 * potential_.size());  // 2 · node + whether a round was completed
    std::vector<std::uint32_t> before(by.size(), no_index), queue{2 * entry};
    for (std::size_t i = 0; i < queue.size() && before[2 * entry + 1] == no_index; ++i)
      for_each_step(queue[i] / 2, [&](const LayeredEdge& s) {
        const std::uint32_t to = 2 * s.to + ((queue[i] % 2 == 1 || s.completes) ? 1 : 0);
        if (!is_tight(s) || components.of[s.to] != components.of[entry] || before[to] != no_index) return;
        before[to] = queue[i];
        by[to] = s;
        queue.push_back(to);
      });
    std::vector<LayeredEdge> out;
    for (std::uint32_t at = 2 * entry + 1; out.empty() || at != 2 * entry; at = before[at]) out.push_back(by[at]);
    std::reverse(out.begin(), out.end());
    return out;
  }

  const MarkedGraph& graph_;
  const AcceptingPart& part_;
  automata::Budget& budget_;
  MeanCycle best_;
  double dearest_ = 0;
  std::vector<double> potential_;  // by node: vertex and marks met
  std::vector<LayeredEdge> parent_;
};

}  // namespace

std::uint64_t rounds_of(const MarkedGraph& graph, const std::vector<std::uint32_t>& edges) {
  std::uint64_t rounds = 0;
  Marks met;
  for (std::uint32_t e : edges) {
    met = (met | graph.edges[e].marks) & graph.all();
    if (met != graph.all()) continue;
    ++rounds;
    met = Marks();
  }
  return rounds;
}

MeanCycle least_mean_cycle(const MarkedGraph& graph, const AcceptingPart& part, const Cycle& known,
                           const std::vector<double>& distance, automata::Budget& budget) {
  return RatioSearch(graph, part, known, budget).run(distance);
}

}  // namespace waymark::plan
