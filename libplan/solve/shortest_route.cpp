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
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <functional>
#include <limits>

namespace waymark::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t polling_interval = 256;  // vertices between two looks at the stop token

// A property map over vertex numbers that grows as an implicit graph does.
template <class T>
class VertexTable {
 public:
  using key_type = std::size_t;
  using value_type = T;
  using reference = T;
  using category = boost::read_write_property_map_tag;

  VertexTable(std::vector<T>& values, T otherwise) : values_(&values), otherwise_(otherwise) {}
  friend T get(const VertexTable& table, std::size_t v) {
    return v < table.values_->size() ? (*table.values_)[v] : table.otherwise_;
  }
  friend void put(const VertexTable& table, std::size_t v, T value) {
    if (v >= table.values_->size()) table.values_->resize(v + 1 + v / 2, table.otherwise_);
    (*table.values_)[v] = value;
  }

 private:
  std::vector<T>* values_;
  T otherwise_;
};

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

std::string no_run(const automata::Dfa& dfa, std::size_t vertices) {
  if (dfa.is_trap(dfa.initial())) return "no finite word satisfies the task";
  return "no route from here satisfies the task (all " + std::to_string(vertices) +
         " reachable pairs of pose and state were searched)";
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

// What differs between the product that was built and the one that is not.
struct Built {
  using Graph = ProductGraph;
  using Vertex = ProductVertex;
  const Product& product;
  const Graph& graph() const { return product.graph; }
  const ProductState& state(Vertex v) const { return product.graph[v]; }
  bool is_accepting(Vertex v) const { return product.is_accepting(v); }
  template <class Edge>
  Action action(const Edge& e) const {
    return product.graph[e].action;
  }
  template <class Edge>
  double cost(const Edge& e) const {
    return product.graph[e].cost;
  }
};
struct Unbuilt {
  using Graph = ImplicitProduct;
  using Vertex = ImplicitProduct::Vertex;
  const ImplicitProduct& product;
  const Graph& graph() const { return product; }
  const ProductState& state(Vertex v) const { return product[v]; }
  bool is_accepting(Vertex v) const { return product.is_accepting(v); }
  Action action(const ImplicitProduct::Edge& e) const { return e.action; }
  double cost(const ImplicitProduct::Edge& e) const { return e.cost; }
};

template <class View>
struct AStar {
  using Graph = typename View::Graph;
  using Vertex = typename View::Vertex;
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;
  struct Step {
    Vertex from;
    Action action;
  };
  struct Found {
    double cost;
    std::vector<Step> steps;
  };

  View view;
  LowerBound& bound;
  const std::stop_token& stop;
  std::size_t expanded = 0;
  bool stopped = false;
  double least = infinity;          // C*: least cost to acceptance found; before that, the cost to beat
  std::vector<double> cost = {};    // g
  std::vector<Vertex> closed = {};  // vertices expanded, in order

  struct Visitor : boost::default_astar_visitor {
    AStar* search;
    VertexTable<double> rank;  // f = g + h
    void examine_vertex(Vertex v, const Graph&) const {
      const double f = get(rank, v);
      if (f == infinity || f > search->least) throw SearchEnds{};
      if (search->expanded++ % polling_interval == 0 && search->stop.stop_requested()) {
        search->stopped = true;
        throw SearchEnds{};
      }
      search->closed.push_back(v);
      if (search->view.is_accepting(v)) search->least = f;
    }
  };

  // The first least-cost route from `start` that costs less than `beat`; nullopt when there is none, or when stopped.
  std::optional<Found> run(Vertex start, double beat) {
    std::vector<double> ranks;
    std::vector<boost::default_color_type> colors;
    cost.clear();
    closed.clear();
    least = beat;
    const VertexTable<double> g(cost, infinity), f(ranks, infinity);
    const VertexTable<boost::default_color_type> color(colors, boost::white_color);
    put(g, start, 0.0);
    put(f, start, bound(view.state(start)));
    try {
      boost::astar_search_no_init(
          view.graph(), start, [this](Vertex v) { return bound(view.state(v)); }, Visitor{{}, this, f},
          boost::dummy_property_map(), f, g,
          boost::make_function_property_map<Edge>([this](const Edge& e) { return view.cost(e); }), color,
          boost::typed_identity_property_map<std::size_t>(), std::less<>(), std::plus<>(), infinity, 0.0);
    } catch (const SearchEnds&) {
    }
    if (stopped || !(least < beat)) return std::nullopt;
    return Found{least, first_route(start)};
  }

  // Least-cost routes run along edges u → v with g(u) + c = g(v) to an accepting vertex with g = C*. In order of
  // falling g every vertex is settled after its successors: the first action that leads on is the one to take.
  std::vector<Step> first_route(Vertex start) {
    const VertexTable<double> g(cost, infinity);
    std::sort(closed.begin(), closed.end(), [&](Vertex a, Vertex b) { return get(g, a) > get(g, b); });
    std::vector<std::uint8_t> leads_on;
    const VertexTable<std::uint8_t> mark(leads_on, 0);
    std::vector<std::pair<Action, Vertex>> choices;
    std::vector<std::uint32_t> choice_of;
    const VertexTable<std::uint32_t> choice(choice_of, 0);
    for (Vertex v : closed) {
      if (get(g, v) == least && view.is_accepting(v)) put(mark, v, std::uint8_t{1});
      if (get(g, v) >= least) continue;
      for (auto [e, end] = out_edges(v, view.graph()); e != end && get(mark, v) == 0; ++e) {
        const Vertex to = target(*e, view.graph());
        if (get(mark, to) == 0 || get(g, v) + view.cost(*e) != get(g, to)) continue;
        put(mark, v, std::uint8_t{1});
        put(choice, v, static_cast<std::uint32_t>(choices.size()));
        choices.emplace_back(view.action(*e), to);
      }
    }
    std::vector<Step> steps;
    for (Vertex v = start; get(g, v) < least; v = choices[get(choice, v)].second)
      steps.push_back({v, choices[get(choice, v)].first});
    return steps;
  }
};

Outcome solve_by_a_star(const Product& product, const ShortestRoute& method) {
  TaskSteps steps(*product.map, *product.dfa);
  LowerBound bound(steps);
  AStar<Built> search{{product}, bound, method.stop};
  std::optional<AStar<Built>::Found> best;
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

RoutePlanner::RoutePlanner(const Map& map, const automata::Dfa& dfa)
    : steps_(map, dfa), bound_(steps_), product_(steps_) {}

RoutePlanner::Answer RoutePlanner::plan(std::span<const PoseId> starts, std::stop_token stop) {
  AStar<Unbuilt> search{{product_}, bound_, stop};
  std::optional<Route> best;
  for (PoseId start : starts) {
    const auto found = search.run(product_.enter(start), best ? best->cost : infinity);
    if (search.stopped) break;
    if (!found) continue;
    Trajectory trajectory{{start}, {}};
    for (const auto& step : found->steps) {
      trajectory.actions.push_back(step.action);
      trajectory.poses.push_back(*steps_.map().successor(trajectory.poses.back(), step.action));
    }
    best = priced(std::move(trajectory), steps_.map());
  }
  expanded_ = search.expanded;
  if (search.stopped) return Exhausted{expanded_};
  if (!best) return Infeasible{no_run(steps_.dfa(), expanded_)};
  return *std::move(best);
}

}  // namespace waymark::plan
