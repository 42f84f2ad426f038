#include "libplan/solve/least_lasso.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

#include "libautomata/omega/emptiness.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/print.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/product/buchi_product.hpp"
#include "libplan/solve/least_cycle.hpp"
#include "libplan/solve/mean_cycle.hpp"

namespace waymark::plan {
namespace {

constexpr std::uint32_t no_edge = UINT32_MAX;

// Least costs from the starts, and the edge by which each vertex is reached.
struct Distances {
  explicit Distances(const MarkedGraph& graph) : cost(graph.vertices(), INFINITY), by(graph.vertices(), no_edge) {
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    for (std::uint32_t v : graph.starts) {
      cost[v] = 0;
      heap.push({0, v});
    }
    while (!heap.empty()) {
      const auto [least, v] = heap.top();
      heap.pop();
      if (least > cost[v]) continue;
      for (std::uint32_t e = graph.first[v]; e < graph.first[v + 1]; ++e) {
        const MarkedEdge& edge = graph.edges[e];
        if (!(least + edge.cost < cost[edge.to])) continue;
        cost[edge.to] = least + edge.cost;
        by[edge.to] = e;
        heap.push({cost[edge.to], edge.to});
      }
    }
  }
  std::vector<double> cost;
  std::vector<std::uint32_t> by;
};

class LassoSearch {
 public:
  LassoSearch(const MarkedGraph& graph, automata::Budget& budget)
      : graph_(graph), budget_(budget), part_(graph), distances_(graph), cycles_(graph, part_, budget) {}

  // The cycle begins where the prefix ends; no edges: there is none.
  MeanCycle run(LassoOrder order) {
    switch (order) {
      case LassoOrder::Prefix: return {prefix_first(), 1};
      case LassoOrder::Cycle: return {cycle_first(), 1};
      case LassoOrder::Mean: break;
    }
    const Cycle known = prefix_first();
    if (known.edges.empty()) return {known, 1};
    return least_mean_cycle(graph_, part_, known, distances_.cost, budget_);
  }
  std::vector<std::uint32_t> way_to(std::uint32_t v) const {
    std::vector<std::uint32_t> edges;
    for (; distances_.by[v] != no_edge; v = graph_.edges[edges.back()].from) edges.push_back(distances_.by[v]);
    std::reverse(edges.begin(), edges.end());
    return edges;
  }

 private:
  // From every vertex where a run can stay that is nearest.
  Cycle prefix_first() {
    double nearest = INFINITY;
    for (std::uint32_t v = 0; v < graph_.vertices(); ++v)
      if (part_.contains(v)) nearest = std::min(nearest, distances_.cost[v]);
    Cycle out{{}, INFINITY};
    for (std::uint32_t v = 0; v < graph_.vertices(); ++v)
      if (part_.contains(v) && distances_.cost[v] == nearest && cycles_.through(v, out.cost) < out.cost)
        out = cycles_.walk();
    return out;
  }

  Cycle cycle_first() {
    Cycle out{{}, INFINITY};
    double least = INFINITY, prefix = INFINITY;
    for (std::uint32_t v : anchors()) {
      const double cost = cycles_.through(v, least);
      if (std::isinf(cost)) continue;
      Cycle walk = cycles_.walk_entered_nearest(distances_.cost);
      const double way = distances_.cost[graph_.edges[walk.edges.front()].from];
      if (cost < least || way < prefix) {
        out = std::move(walk);
        prefix = way;
      }
      least = cost;
    }
    return out;
  }

  // Vertices of which every cycle that we look for has one: the sources of the edges with the rarest mark.
  std::vector<std::uint32_t> anchors() const {
    std::vector<std::uint32_t> best;
    for (std::uint32_t mark = 0; mark < std::max(graph_.sets, 1U); ++mark) {
      std::vector<std::uint32_t> sources;
      for (const MarkedEdge& e : graph_.edges)
        if (part_.keeps(e) && (graph_.sets == 0 || e.marks.contains(mark)) &&
            (sources.empty() || sources.back() != e.from))
          sources.push_back(e.from);
      if (mark == 0 || sources.size() < best.size()) best = std::move(sources);
    }
    return best;
  }

  const MarkedGraph& graph_;
  automata::Budget& budget_;
  const AcceptingPart part_;
  const Distances distances_;
  LeastCycles cycles_;
};

ChoiceRoute route_of(const BuchiProduct& product, std::uint32_t from, const std::vector<std::uint32_t>& edges) {
  ChoiceRoute out;
  out.places.push_back(product.states[from].place);
  for (std::uint32_t e : edges) {
    const MarkedEdge& edge = product.graph.edges[e];
    out.choices.push_back(edge.choice);
    out.places.push_back(product.states[edge.to].place);
    out.cost += edge.cost;
  }
  return out;
}

struct LassoLetters {
  std::vector<ltl::Letter> prefix, cycle;
};
// The letter that the cycle ends with is that of its closing step: the place may carry another one the first time.
template <class Model>
LassoLetters letters_of(const Model& model, const LassoRoute& route) {
  if (route.prefix.places.front() != model.initial())
    throw std::logic_error("a lasso that does not begin at the start");
  if (route.cycle.choices.empty() || route.cycle.places.front() != route.cycle.places.back() ||
      route.cycle.places.front() != route.prefix.places.back())
    throw std::logic_error("a lasso that does not close");
  const ltl::Trace prefix = word_of(model, route.prefix), cycle = word_of(model, route.cycle);
  return {{prefix.begin(), prefix.end()}, {cycle.begin() + 1, cycle.end()}};
}

}  // namespace

std::string_view name(LassoOrder order) {
  switch (order) {
    case LassoOrder::Prefix: return "prefix";
    case LassoOrder::Cycle: return "cycle";
    case LassoOrder::Mean: return "mean";
  }
  return {};
}

template <class Model>
std::optional<LassoAnswer> least_lasso(const Model& model, const automata::Automaton& automaton, LassoOrder order,
                                       const ltl::Limits& limits) {
  try {
    automata::Budget budget(SIZE_MAX, limits.states, limits.stop);
    const BuchiProduct product = compose(model, automaton, budget);
    LassoAnswer answer{std::nullopt, {product.states.size(), product.graph.edges.size()}};
    LassoSearch search(product.graph, budget);
    const MeanCycle found = search.run(order);
    if (found.cycle.edges.empty()) return answer;
    const std::uint32_t entry = product.graph.edges[found.cycle.edges.front()].from;
    const std::vector<std::uint32_t> way = search.way_to(entry);
    const std::uint32_t start = way.empty() ? entry : product.graph.edges[way.front()].from;
    answer.route = LassoRoute{route_of(product, start, way), route_of(product, entry, found.cycle.edges), found.rounds};
    return answer;
  } catch (const automata::Budget::Exceeded&) {
    return std::nullopt;
  }
}

template <class Model>
ltl::Lasso word_of(const Model& model, const LassoRoute& route) {
  const LassoLetters word = letters_of(model, route);
  return ltl::Lasso(word.prefix, word.cycle);
}

template <class Model>
CertifiedLasso certify(LassoRoute route, const Model& model, ltl::Formula f) {
  if (!ltl::holds(word_of(model, route), f))
    throw std::logic_error("a lasso whose word does not satisfy " + ltl::print(f));
  return CertifiedLasso(std::move(route), true);
}

template <class Model>
CertifiedLasso certify(LassoRoute route, const Model& model, const automata::Automaton& automaton) {
  const LassoLetters word = letters_of(model, route);
  const auto read = [&](const std::vector<ltl::Letter>& letters) {
    return as_read(letters, model.letters().vocabulary(), automaton.vocabulary(), automaton.reads());
  };
  if (!automata::accepts(automaton, ltl::Lasso(read(word.prefix), read(word.cycle))))
    throw std::logic_error("a lasso whose word the automaton does not accept");
  return CertifiedLasso(std::move(route), false);
}

template std::optional<LassoAnswer> least_lasso(const Mdp&, const automata::Automaton&, LassoOrder, const ltl::Limits&);
template std::optional<LassoAnswer> least_lasso(const GridWorld&, const automata::Automaton&, LassoOrder,
                                                const ltl::Limits&);
template ltl::Lasso word_of(const Mdp&, const LassoRoute&);
template ltl::Lasso word_of(const GridWorld&, const LassoRoute&);
template CertifiedLasso certify(LassoRoute, const Mdp&, ltl::Formula);
template CertifiedLasso certify(LassoRoute, const GridWorld&, ltl::Formula);
template CertifiedLasso certify(LassoRoute, const Mdp&, const automata::Automaton&);
template CertifiedLasso certify(LassoRoute, const GridWorld&, const automata::Automaton&);

}  // namespace waymark::plan
