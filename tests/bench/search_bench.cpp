// The searches of ours beside those of Boost.Graph, on the same products: is a search of our own worth its lines?
//
//   hallways   RoutePlanner, and boost::breadth_first_visit; 512 random pairs of start and task on the map grid
//   grids      plan::search, and Boost's breadth first, A* (with GridBound) and Dijkstra; 1000² cells, a fifth of them
//              walls, two landmarks to be visited in order; argument `even`: all moves cost the same, or N and S twice
// Boost gets arrays by pair for costs and heap positions, and a bit a pair for colours where two colours do.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/pending/queue.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/solve/grid_bound.hpp"
#include "libplan/solve/product_search.hpp"
#include "libplan/solve/route_planner.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::plan {
namespace {

struct Found {};  // thrown by visitors: the way out of a Boost.Graph search

// Met or not, a bit a pair; the places of a state of the task are added when it is first met.
struct Bits {
  Bits(std::size_t places, std::size_t tasks) : words(places / 64 + 1), rows(tasks) {}
  bool contains(const ProductState& s) const {
    const auto& row = rows[s.task];
    return !row.empty() && ((row[s.place / 64] >> (s.place % 64)) & 1U) != 0;
  }
  void insert(const ProductState& s) {
    auto& row = rows[s.task];
    if (row.empty()) {
      row.resize(words);
      used.push_back(s.task);
    }
    row[s.place / 64] |= std::uint64_t{1} << (s.place % 64);
  }
  void clear() {
    for (const std::uint32_t task : used) rows[task].clear();
    used.clear();
  }
  std::size_t words;
  std::vector<std::vector<std::uint64_t>> rows;
  std::vector<std::uint32_t> used;
};
struct Colors {
  using key_type = ProductState;
  using value_type = boost::default_color_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  Bits* bits;
  friend value_type get(const Colors& c, const ProductState& s) {
    return c.bits->contains(s) ? boost::black_color : boost::white_color;
  }
  friend void put(const Colors& c, const ProductState& s, value_type color) {
    if (color == boost::gray_color) c.bits->insert(s);
  }
};

struct Met {
  ProductState state;
  std::uint32_t from;
};
struct RouteVisitor : boost::default_bfs_visitor {  // keeps what a route is read off
  std::vector<Met>* met;
  std::uint32_t* examined;
  template <class Graph>
  void examine_vertex(const ProductState&, const Graph&) const {
    ++*examined;
  }
  template <class Graph>
  void discover_vertex(const ProductState& s, const Graph& g) const {
    met->push_back({s, *examined});
    if (g.is_goal(s)) throw Found{};
  }
};

class BreadthFirst {  // what it allocates is kept from one search to the next
 public:
  BreadthFirst(std::size_t places, std::size_t tasks) : bits_(places, tasks) {}
  template <class Graph>
  std::size_t run(const Graph& product, const ProductState& start) {
    bits_.clear();
    met_.clear();
    std::uint32_t examined = 0;
    boost::queue<ProductState> open;
    RouteVisitor visitor;
    visitor.met = &met_;
    visitor.examined = &examined;
    try {
      boost::breadth_first_visit(product, start, open, visitor, Colors{&bits_});
    } catch (const Found&) {
    }
    return met_.size();
  }

 private:
  Bits bits_;
  std::vector<Met> met_;
};

using GridProduct = Product<GridWorld, TaskTable>;
struct Index {  // of all pairs there could be
  using key_type = ProductState;
  using value_type = std::size_t;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  std::size_t places;
  friend std::size_t get(const Index& i, const ProductState& s) { return s.task * i.places + s.place; }
};
struct Costs {
  using key_type = ProductEdge;
  using value_type = double;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const GridProduct* product;
  friend double get(const Costs& c, const ProductEdge& e) { return c.product->cost(e); }
};
struct GoalVisitor : boost::default_astar_visitor {
  double* reached;
  const std::vector<double>* cost;
  Index index;
  void examine_vertex(const ProductState& s, const GridProduct& g) const {
    if (!g.is_goal(s)) return;
    *reached = (*cost)[get(index, s)];
    throw Found{};
  }
};
struct Arrays {
  explicit Arrays(const GridProduct& product)
      : index{product.model().states()},
        cost(index.places * product.task().states(), INFINITY),
        rank(cost),
        before(cost.size()),
        color(cost.size(), boost::white_color) {}
  Index index;
  std::vector<double> cost, rank;
  std::vector<ProductState> before;
  std::vector<boost::default_color_type> color;
  template <class Values>
  auto map(Values& values) const {
    return boost::make_iterator_property_map(values.begin(), index);
  }
};

double by_dijkstra(const GridProduct& product, const ProductState& start) {
  Arrays at(product);
  double reached = INFINITY;
  GoalVisitor visitor;
  visitor.reached = &reached;
  visitor.cost = &at.cost;
  visitor.index = at.index;
  at.cost[get(at.index, start)] = 0;
  try {
    boost::dijkstra_shortest_paths_no_init(product, start, at.map(at.before), at.map(at.cost), Costs{&product},
                                           at.index, std::less<>(), std::plus<>(), 0.0, visitor, at.map(at.color));
  } catch (const Found&) {
  }
  return reached;
}

double by_a_star(const GridProduct& product, const ProductState& start) {
  const GridBound bound = GridBound::of(product.model(), product.task()).value();
  const auto heuristic = [&](const ProductState& s) {
    const std::uint32_t rest = bound(s.place, s.task);
    return rest == GridBound::never ? INFINITY : static_cast<double>(rest);
  };
  Arrays at(product);
  double reached = INFINITY;
  GoalVisitor visitor;
  visitor.reached = &reached;
  visitor.cost = &at.cost;
  visitor.index = at.index;
  at.cost[get(at.index, start)] = 0;
  at.rank[get(at.index, start)] = heuristic(start);
  try {
    boost::astar_search_no_init(product, start, heuristic, visitor, at.map(at.before), at.map(at.rank), at.map(at.cost),
                                Costs{&product}, at.map(at.color), at.index, std::less<>(), std::plus<>(),
                                double{INFINITY}, 0.0);
  } catch (const Found&) {
  }
  return reached;
}

// ---- hallways

struct Hallways512 {
  struct Pair {
    PoseId start;
    std::size_t task;
  };
  Hallways512() : map(read_map("grid", WAYMARK_SOURCE_DIR "/data")), arena(map.vocabulary()) {
    for (const char* text : {"F (chair & X F sofa)", "F (sofa & F (easel & F lamp))", "X (moved U (moved & corner))",
                             "F (hatrack & F (chair & F sofa))"})
      tasks.push_back(automata::ltlf_to_dfa(ltl::parse(text, arena)));
    ltl::Random random(1);
    while (pairs.size() < 512) {
      const Pair pair{PoseId{static_cast<std::uint32_t>(random.below(map.poses()))}, random.below(tasks.size())};
      pairs.push_back(pair);
    }
  }
  Map map;
  ltl::Arena arena;
  std::vector<automata::Dfa> tasks;
  std::vector<Pair> pairs;
};

void hallways_ours(benchmark::State& state) {
  const Hallways512 work;
  std::vector<RoutePlanner> planners;
  for (const automata::Dfa& dfa : work.tasks) planners.emplace_back(work.map, dfa);
  for (auto _ : state)
    for (const auto& pair : work.pairs) benchmark::DoNotOptimize(planners[pair.task].plan(pair.start));
}

void hallways_boost(benchmark::State& state) {
  const Hallways512 work;
  std::vector<TaskSteps> steps;
  for (const automata::Dfa& dfa : work.tasks) steps.emplace_back(work.map, dfa, TaskSteps::Traps::LeftOut);
  const MapMdp model(work.map);
  std::vector<BreadthFirst> searches;
  for (const TaskSteps& task : steps) searches.emplace_back(model.states(), task.states());
  for (auto _ : state)
    for (const auto& pair : work.pairs) {
      const Product product(model, steps[pair.task]);
      product.for_each_start(pair.start.index, work.map.label_id(pair.start), [&](const ProductState& s) {
        benchmark::DoNotOptimize(searches[pair.task].run(product, s));
      });
    }
}

// ---- grids

struct Scatter {
  static constexpr std::uint32_t side = 1000;
  explicit Scatter(bool even) : grid(made(even)), arena(grid.letters().vocabulary()) {
    dfa.push_back(automata::ltlf_to_dfa(ltl::parse("F (a & F b)", arena)));
    table.emplace_back(dfa[0], grid.letters());
  }
  static GridWorld made(bool even) {
    ltl::Random random(1);
    std::vector<std::uint16_t> cells;
    for (std::uint32_t i = 0; i < side * side; ++i) cells.push_back(random.below(5) == 0 ? 1 : 0);
    cells[0] = 0;
    cells[side * (side / 2) + side - 20] = 2;
    cells[side * (side - 20) + side / 3] = 3;
    GridWorld::Shape shape{.width = side, .height = side};
    if (!even) shape.cost = {2, 1, 2, 1};
    return GridWorld(
        shape, ltl::Vocabulary({"a", "b"}),
        {{}, {.wall = true}, {.label = ltl::Letter{ltl::Proposition{0}}}, {.label = ltl::Letter{ltl::Proposition{1}}}},
        cells, 0);
  }
  GridWorld grid;
  ltl::Arena arena;
  std::vector<automata::Dfa> dfa;
  std::vector<TaskTable> table;
};

template <class Search>  // search(product, start): the cost that it found
void run(benchmark::State& state, Search&& search) {
  const Scatter work(state.range(0) != 0);
  const GridProduct product(work.grid, work.table[0]);
  std::vector<ProductState> start;
  product.for_each_start([&](const ProductState& s) { start.push_back(s); });
  double cost = 0;
  for (auto _ : state) cost = search(product, start.at(0));
  state.counters["cost"] = benchmark::Counter(cost);
}
void grid_ours(benchmark::State& state) {
  run(state, [](const GridProduct& product, const ProductState&) { return search(product)->route->cost; });
}
void grid_boost_breadth_first(benchmark::State& state) {
  run(state, [](const GridProduct& product, const ProductState& start) {
    BreadthFirst search(product.model().states(), product.task().states());
    return static_cast<double>(search.run(product, start));
  });
}
void grid_boost_a_star(benchmark::State& state) { run(state, by_a_star); }
void grid_boost_dijkstra(benchmark::State& state) { run(state, by_dijkstra); }

BENCHMARK(hallways_ours)->Unit(benchmark::kMillisecond);
BENCHMARK(hallways_boost)->Unit(benchmark::kMillisecond);
BENCHMARK(grid_ours)->Arg(1)->Arg(0)->ArgName("even")->Unit(benchmark::kMillisecond);
BENCHMARK(grid_boost_breadth_first)->Arg(1)->ArgName("even")->Unit(benchmark::kMillisecond);
BENCHMARK(grid_boost_a_star)->Arg(1)->Arg(0)->ArgName("even")->Unit(benchmark::kMillisecond);
BENCHMARK(grid_boost_dijkstra)->Arg(1)->Arg(0)->ArgName("even")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace waymark::plan
