// Both directions end in the same way. A search yields exact costs on a region that holds every least-cost route; in
// it the edges u → v with cost(u) + c = cost(v) are the least-cost routes, and the lexicographically least one takes at
// each vertex the first action that still leads to the goal along such edges.
//
// Backwards (Dijkstra) costs are costs to go, so "still leads to the goal" holds by itself. Forwards (A*) the search
// goes on until every vertex with f ≤ C* is expanded, C* the least cost, and a pass in order of falling cost finds the
// vertices from which the goal is reached at C*. Actions cost more than nothing, so that order is well founded; costs
// are whole numbers, so that equal sums are equal doubles.
#include "libplan/solve/shortest_route.hpp"

#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/reverse_graph.hpp>
#include <boost/property_map/property_map.hpp>
#include <functional>
#include <limits>
#include <unordered_map>

#include "libplan/solve/lower_bound.hpp"
#include "libplan/solve/route.hpp"

namespace waymark::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t polling_interval = 256;  // vertices between two looks at the stop token

struct SearchEnds {};  // thrown by visitors: the way out of a Boost.Graph search

// ---- backwards: Dijkstra from all accepting vertices ------------------------------------------------------------

struct CountingVisitor : boost::dijkstra_visitor<> {
  std::size_t* expanded;
  const std::stop_token* stop;

  template <class Vertex, class Graph>
  void examine_vertex(Vertex, const Graph&) const {
    if ((*expanded)++ % polling_interval == 0 && stop->stop_requested()) throw SearchEnds{};
  }
};

// Cost to acceptance by vertex; nullopt when stopped.
std::optional<std::vector<double>> costs_to_go(const Product& product, const std::stop_token& stop,
                                               std::size_t& expanded) {
  const ProductGraph& graph = product.graph;
  std::vector<ProductVertex> accepting;
  for (ProductVertex v = 0; v < num_vertices(graph); ++v)
    if (product.is_accepting(v)) accepting.push_back(v);
  std::vector<double> cost(num_vertices(graph), infinity);
  if (accepting.empty()) return cost;
  const auto reversed = boost::make_reverse_graph(graph);
  const auto index = get(boost::vertex_index, reversed);
  CountingVisitor visitor;
  visitor.expanded = &expanded;
  visitor.stop = &stop;
  try {
    boost::dijkstra_shortest_paths(reversed, accepting.begin(), accepting.end(), boost::dummy_property_map(),
                                   boost::make_iterator_property_map(cost.begin(), index),
                                   get(&ProductEdge::cost, reversed), index, std::less<>(), std::plus<>(),
                                   infinity, 0.0, visitor);
  } catch (const SearchEnds&) {
    return std::nullopt;
  }
  return cost;
}

// In each vertex the first action that begins a least-cost route. Walked from the far end of the edge costs were added
// at, so equality is exact.
std::vector<std::optional<Action>> first_best_actions(const Product& product,
                                                      const std::vector<double>& cost) {
  std::vector<std::optional<Action>> actions(cost.size());
  for (ProductVertex v = 0; v < cost.size(); ++v) {
    if (product.is_accepting(v) || cost[v] == infinity) continue;
    for (auto [e, end] = out_edges(v, product.graph); e != end && !actions[v]; ++e)
      if (product.graph[*e].cost + cost[target(*e, product.graph)] == cost[v])
        actions[v] = product.graph[*e].action;
  }
  return actions;
}

Outcome solve_by_dijkstra(const Product& product, const ShortestRoute& method) {
  std::size_t expanded = 0;
  const auto cost = costs_to_go(product, method.stop, expanded);
  if (!cost) return Exhausted{expanded};
  const auto start =
      std::min_element(product.starts.begin(), product.starts.end(),
                       [&](ProductVertex a, ProductVertex b) { return (*cost)[a] < (*cost)[b]; });
  if (start == product.starts.end() || (*cost)[*start] == infinity)
    return Infeasible{no_run(*product.dfa, num_vertices(product.graph))};
  const double value = (*cost)[*start];
  return Solved{{first_best_actions(product, *cost), *start}, value, value, value, expanded};
}

// ---- forwards: A* -----------------------------------------------------------------------------------------------

struct AStar {
  using Vertex = ProductVertex;
  using Edge = ProductGraph::edge_descriptor;
  struct Step {
    Vertex from;
    Action action;
  };
  struct Found {
    double cost;
    std::vector<Step> steps;
  };

  const Product& product;
  LowerBound& bound;
  const std::stop_token& stop;
  std::size_t expanded = 0;
  bool stopped = false;
  double least = infinity;          // C*: least cost to acceptance found; before that, the cost to beat
  std::vector<double> cost = {};    // g
  std::vector<Vertex> closed = {};  // vertices expanded, in order

  struct Visitor : boost::default_astar_visitor {
    AStar* search;
    const std::vector<double>* rank;  // f = g + h
    void examine_vertex(Vertex v, const ProductGraph&) const {
      const double f = (*rank)[v];
      if (f == infinity || f > search->least) throw SearchEnds{};
      if (search->expanded++ % polling_interval == 0 && search->stop.stop_requested()) {
        search->stopped = true;
        throw SearchEnds{};
      }
      search->closed.push_back(v);
      if (search->product.is_accepting(v)) search->least = f;
    }
  };

  // The first least-cost route from `start` that costs less than `beat`; nullopt when there is none, or when stopped.
  std::optional<Found> run(Vertex start, double beat) {
    const ProductGraph& graph = product.graph;
    const auto index = get(boost::vertex_index, graph);
    std::vector<double> ranks(num_vertices(graph), infinity);
    std::vector<boost::default_color_type> colors(num_vertices(graph), boost::white_color);
    cost.assign(num_vertices(graph), infinity);
    closed.clear();
    least = beat;
    cost[start] = 0;
    ranks[start] = bound(graph[start]);
    Visitor visitor;
    visitor.search = this;
    visitor.rank = &ranks;
    try {
      boost::astar_search_no_init(
          graph, start, [&](Vertex v) { return bound(graph[v]); }, visitor, boost::dummy_property_map(),
          boost::make_iterator_property_map(ranks.begin(), index),
          boost::make_iterator_property_map(cost.begin(), index), get(&ProductEdge::cost, graph),
          boost::make_iterator_property_map(colors.begin(), index), index, std::less<>(), std::plus<>(),
          infinity, 0.0);
    } catch (const SearchEnds&) {
    }
    if (stopped || !(least < beat)) return std::nullopt;
    return Found{least, first_route(start)};
  }

  // Least-cost routes run along edges u → v with g(u) + c = g(v) to an accepting vertex with g = C*. In order of
  // falling g every vertex is settled after its successors: the first action that leads on is the one to take.
  std::vector<Step> first_route(Vertex start) {
    const ProductGraph& graph = product.graph;
    std::sort(closed.begin(), closed.end(), [&](Vertex a, Vertex b) { return cost[a] > cost[b]; });
    std::vector<bool> leads_on(cost.size(), false);
    std::unordered_map<Vertex, Edge> choice;
    for (Vertex v : closed) {
      if (cost[v] == least && product.is_accepting(v)) leads_on[v] = true;
      if (cost[v] >= least) continue;
      for (auto [e, end] = out_edges(v, graph); e != end && !leads_on[v]; ++e) {
        const Vertex to = target(*e, graph);
        if (!leads_on[to] || cost[v] + graph[*e].cost != cost[to]) continue;
        leads_on[v] = true;
        choice.emplace(v, *e);
      }
    }
    std::vector<Step> steps;
    for (Vertex v = start; cost[v] < least; v = target(choice.at(v), graph))
      steps.push_back({v, graph[choice.at(v)].action});
    return steps;
  }
};

Outcome solve_by_a_star(const Product& product, const ShortestRoute& method) {
  TaskSteps steps(*product.map, *product.dfa);
  LowerBound bound(steps);
  AStar search{product, bound, method.stop};
  std::optional<AStar::Found> best;
  Policy policy{std::vector<std::optional<Action>>(num_vertices(product.graph)), 0};
  for (ProductVertex start : product.starts) {
    auto found = search.run(start, best ? best->cost : infinity);
    if (search.stopped) return Exhausted{search.expanded};
    if (!found) continue;
    best = std::move(found);
    policy.start = start;
  }
  if (!best) return Infeasible{no_run(*product.dfa, num_vertices(product.graph))};
  for (const auto& step : best->steps) policy.action[step.from] = step.action;
  return Solved{std::move(policy), best->cost, best->cost, best->cost, search.expanded};
}

}  // namespace

Outcome solve(const Product& product, const ShortestRoute& method) {
  switch (method.algorithm) {
    case ShortestRoute::Algorithm::AStar: return solve_by_a_star(product, method);
    case ShortestRoute::Algorithm::Dijkstra: return solve_by_dijkstra(product, method);
  }
  throw std::logic_error("not an algorithm");
}

}  // namespace waymark::plan
