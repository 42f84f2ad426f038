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
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>
#include <functional>
#include <limits>
#include <unordered_map>

#include "libplan/solve/lower_bound.hpp"
#include "libplan/solve/route.hpp"

namespace waymark::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t vertices_between_polls = 256;  // vertices between two looks at the stop token

struct SearchEnds {};  // thrown by visitors: the way out of a Boost.Graph search

struct IndexMap {
  using key_type = ProductState;
  using value_type = std::size_t;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const MapProduct* product;
  friend std::size_t get(const IndexMap& map, const ProductState& v) { return map.product->index(v); }
};

// ---- backwards: Dijkstra from all accepting vertices ------------------------------------------------------------

struct CountingVisitor : boost::dijkstra_visitor<> {
  std::size_t* expanded;
  const std::stop_token* stop;

  template <class Vertex, class Graph>
  void examine_vertex(Vertex, const Graph&) const {
    if ((*expanded)++ % vertices_between_polls == 0 && stop->stop_requested()) throw SearchEnds{};
  }
};

// The edges turned round: a product knows the successors of a pair, not what it is a successor of.
using Reversed = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                       boost::property<boost::edge_weight_t, double>>;

Reversed reversed(const MapProduct& product) {
  Reversed out(num_vertices(product));
  for (const ProductState& v : boost::make_iterator_range(vertices(product)))
    for (auto [e, end] = out_edges(v, product); e != end; ++e)
      add_edge(product.index(e->to), product.index(v), product.cost(*e), out);
  return out;
}

// Cost to acceptance by index; nullopt when stopped.
std::optional<std::vector<double>> costs_to_go(const MapProduct& product, const std::stop_token& stop,
                                               std::size_t& expanded) {
  std::vector<std::size_t> accepting;
  for (const ProductState& v : boost::make_iterator_range(vertices(product)))
    if (product.is_accepting(v)) accepting.push_back(product.index(v));
  std::vector<double> cost(num_vertices(product), infinity);
  if (accepting.empty()) return cost;
  const Reversed graph = reversed(product);
  const auto index = get(boost::vertex_index, graph);
  CountingVisitor visitor;
  visitor.expanded = &expanded;
  visitor.stop = &stop;
  try {
    boost::dijkstra_shortest_paths(graph, accepting.begin(), accepting.end(), boost::dummy_property_map(),
                                   boost::make_iterator_property_map(cost.begin(), index),
                                   get(boost::edge_weight, graph), index, std::less<>(), std::plus<>(), infinity, 0.0,
                                   visitor);
  } catch (const SearchEnds&) {
    return std::nullopt;
  }
  return cost;
}

// In each vertex the first action that begins a least-cost route. Walked from the far end of the edge costs were added
// at, so equality is exact.
std::vector<std::optional<Action>> first_best_actions(const MapProduct& product, const std::vector<double>& cost) {
  std::vector<std::optional<Action>> actions(cost.size());
  for (const ProductState& v : boost::make_iterator_range(vertices(product))) {
    const std::size_t i = product.index(v);
    if (product.is_accepting(v) || cost[i] == infinity) continue;
    for (auto [e, end] = out_edges(v, product); e != end && !actions[i]; ++e)
      if (product.cost(*e) + cost[product.index(e->to)] == cost[i]) actions[i] = product.action(*e);
  }
  return actions;
}

Outcome solve_by_dijkstra(const MapProduct& product, const ShortestRoute& method) {
  std::size_t expanded = 0;
  const auto cost = costs_to_go(product, method.stop, expanded);
  if (!cost) return Exhausted{expanded};
  const auto cost_of = [&](const ProductState& v) { return (*cost)[product.index(v)]; };
  const auto start =
      std::min_element(product.starts().begin(), product.starts().end(),
                       [&](const ProductState& a, const ProductState& b) { return cost_of(a) < cost_of(b); });
  if (start == product.starts().end() || cost_of(*start) == infinity)
    return Infeasible{no_run(product.dfa(), num_vertices(product))};
  const double value = cost_of(*start);
  return Solved{{first_best_actions(product, *cost), *start}, value, value, value, expanded};
}

// ---- forwards: A* -----------------------------------------------------------------------------------------------

struct CostMap {
  using key_type = ProductEdge;
  using value_type = double;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const MapProduct* product;
  friend double get(const CostMap& map, const ProductEdge& e) { return map.product->cost(e); }
};

struct AStar {
  using Vertex = ProductState;
  using Edge = ProductEdge;
  struct Found {
    double cost;
    std::vector<Edge> steps;
  };

  const MapProduct& product;
  LowerBound& bound;
  const std::stop_token& stop;
  std::size_t expanded = 0;
  bool stopped = false;
  double least = infinity;          // C*: least cost to acceptance found; before that, the cost to beat
  std::vector<double> cost = {};    // g, by index
  std::vector<Vertex> closed = {};  // vertices expanded, in order

  struct Visitor : boost::default_astar_visitor {
    AStar* search;
    const std::vector<double>* rank;  // f = g + h, by index
    void examine_vertex(const Vertex& v, const MapProduct& met) const {
      const double f = (*rank)[met.index(v)];
      if (f == infinity || f > search->least) throw SearchEnds{};
      if (search->expanded++ % vertices_between_polls == 0 && search->stop.stop_requested()) {
        search->stopped = true;
        throw SearchEnds{};
      }
      search->closed.push_back(v);
      if (met.is_accepting(v)) search->least = f;
    }
  };

  // The first least-cost route from `start` that costs less than `beat`; nullopt when there is none, or when stopped.
  std::optional<Found> run(const Vertex& start, double beat) {
    const IndexMap index{&product};
    std::vector<double> ranks(num_vertices(product), infinity);
    std::vector<boost::default_color_type> colors(num_vertices(product), boost::white_color);
    cost.assign(num_vertices(product), infinity);
    closed.clear();
    least = beat;
    cost[product.index(start)] = 0;
    ranks[product.index(start)] = bound(start);
    Visitor visitor;
    visitor.search = this;
    visitor.rank = &ranks;
    try {
      boost::astar_search_no_init(
          product, start, [&](const Vertex& v) { return bound(v); }, visitor, boost::dummy_property_map(),
          boost::make_iterator_property_map(ranks.begin(), index),
          boost::make_iterator_property_map(cost.begin(), index), CostMap{&product},
          boost::make_iterator_property_map(colors.begin(), index), index, std::less<>(), std::plus<>(), infinity, 0.0);
    } catch (const SearchEnds&) {
    }
    if (stopped || !(least < beat)) return std::nullopt;
    return Found{least, first_route(start)};
  }

  // Least-cost routes run along edges u → v with g(u) + c = g(v) to an accepting vertex with g = C*. In order of
  // falling g every vertex is settled after its successors: the first action that leads on is the one to take.
  std::vector<Edge> first_route(const Vertex& start) {
    const auto g = [&](const Vertex& v) { return cost[product.index(v)]; };
    std::sort(closed.begin(), closed.end(), [&](const Vertex& a, const Vertex& b) { return g(a) > g(b); });
    std::vector<bool> leads_on(cost.size(), false);
    std::unordered_map<std::size_t, Edge> choice;  // by index
    for (const Vertex& v : closed) {
      const std::size_t i = product.index(v);
      if (product.is_accepting(v)) leads_on[i] = true;  // at C*, where the search ends
      if (cost[i] >= least) continue;
      for (auto [e, end] = out_edges(v, product); e != end && !leads_on[i]; ++e) {
        const std::size_t to = product.index(e->to);
        if (!leads_on[to] || cost[i] + product.cost(*e) != cost[to]) continue;
        leads_on[i] = true;
        choice.emplace(i, *e);
      }
    }
    std::vector<Edge> steps;
    for (Vertex v = start; g(v) < least; v = steps.back().to) steps.push_back(choice.at(product.index(v)));
    return steps;
  }
};

Outcome solve_by_a_star(const MapProduct& product, const ShortestRoute& method) {
  LowerBound bound(product.task());
  AStar search{product, bound, method.stop};
  std::optional<AStar::Found> best;
  Policy policy{std::vector<std::optional<Action>>(num_vertices(product)), {}};
  for (const ProductState& start : product.starts()) {
    auto found = search.run(start, best ? best->cost : infinity);
    if (search.stopped) return Exhausted{search.expanded};
    if (!found) continue;
    best = std::move(found);
    policy.start = start;
  }
  if (!best) return Infeasible{no_run(product.dfa(), num_vertices(product))};
  for (const ProductEdge& step : best->steps) policy.action[product.index(step.from)] = product.action(step);
  return Solved{std::move(policy), best->cost, best->cost, best->cost, search.expanded};
}

}  // namespace

Outcome solve(const MapProduct& product, const ShortestRoute& method) {
  switch (method.algorithm) {
    case ShortestRoute::Algorithm::AStar: return solve_by_a_star(product, method);
    case ShortestRoute::Algorithm::Dijkstra: return solve_by_dijkstra(product, method);
  }
  throw std::logic_error("not an algorithm");
}

}  // namespace waymark::plan
