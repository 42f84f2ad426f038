// What solvers say of their work, on grids that are drawn from a seed and on shipped maps. Counts are repeatable: a
// worse start of sweeps, a bound that prunes less, or a threshold that is met later shows here, where values are the
// same. After a change that is meant to change them, the new ones are what the failing test prints.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/solve/decide.hpp"
#include "libplan/solve/least_routes.hpp"
#include "libplan/solve/product_search.hpp"
#include "libplan/solve/shortest_route.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

PlanningCase drawn(GridKind kind, std::uint32_t width, std::uint32_t height, double noise) {
  std::ostringstream text;
  write_case(text, generate_grid({.kind = kind, .width = width, .height = height, .noise = noise, .seed = 9}));
  return parse_case(text.str());
}

// Of the sequence a, b and of the same past no hazard.
constexpr const char* tasks[] = {"F (a & F b)", "!x U (a & (!x U b))"};

template <class Count>
std::string of_tasks(const PlanningCase& read, const Count& count) {
  const auto& grid = std::get<GridWorld>(read.model);
  std::ostringstream out;
  for (const char* text : tasks) {
    ltl::Arena arena(grid.letters().vocabulary());
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(text, arena));
    const TaskTable task(dfa, grid.letters());
    count(grid, task, out);
  }
  return out.str();
}

struct Row {
  GridKind kind;
  const char* counts;
};

// The last digits of sums decide when sweeps end; where products are fused into them, they are others.
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
constexpr bool fused = true;
#else
constexpr bool fused = false;
#endif

// Least costs and greatest probabilities: in place, of equations written out, by policies, of states one by one.
TEST(Counts, OfSweeps) {
  if (fused) GTEST_SKIP() << "products are fused into sums";
  const IterationOptions ways[] = {{.on_grid = 0}, {}, {.policy_iteration = true}, {.written_out = 0}};
  const Row rows[] = {{GridKind::Rooms, "48 0  48 0  18 0  89 0  48 0  48 0  18 0  89 0  "},
                      {GridKind::Scatter, "72 0  90 0  16 0  127 0  0 116  0 146  0 25  0 148  "},
                      {GridKind::Bridge, "70 0  103 0  23 0  157 0  0 159  0 216  0 12  0 218  "},
                      {GridKind::OneWay, "42 0  28 0  14 0  87 0  42 0  28 0  14 0  87 0  "}};
  for (const Row& row : rows)
    EXPECT_EQ(of_tasks(drawn(row.kind, 30, 24, 0.1),
                       [&](const GridWorld& grid, const TaskTable& task, std::ostream& out) {
                         const auto product = ProductMdp<GridWorld>::explore(grid, task);
                         for (const IterationOptions& way : ways)
                           out << least_cost(*product, way).value().sweeps << ' '
                               << greatest_probability(*product, way).value().sweeps << "  ";
                       }),
              row.counts)
        << name(row.kind);
}

// Pairs met and edges looked at: the only route, by A* first, and the five cheapest.
TEST(Counts, OfSearches) {
  const Row rows[] = {{GridKind::Rooms, "1396 5212  11595 46360  1396 5212  11595 46360  1780 7108  1780 7108  "},
                      {GridKind::Maze, "162 628  1045 4160  162 628  1045 4160  20633 82472  20633 82472  "},
                      {GridKind::Scatter, "1250 4688  10010 40020  976 3604  8240 32940  4695 18768  2939 11748  "},
                      {GridKind::OneWay, "451 1620  3740 14940  451 1620  3740 14940  2511 10040  2511 10040  "}};
  for (const Row& row : rows) {
    const auto count = [](const auto& found, std::ostream& out) {
      out << found.value().statistics.met << ' ' << found.value().statistics.edges << "  ";
    };
    std::string counts;
    for (const std::uint32_t size : {40U, 180U})
      counts += of_tasks(drawn(row.kind, size, size, 0),
                         [&](const GridWorld& grid, const TaskTable& task, std::ostream& out) {
                           count(search(Product(grid, task)), out);
                           if (size < 100) count(least_routes(Product(grid, task), 5), out);
                         });
    EXPECT_EQ(counts, row.counts) << name(row.kind);
  }
}

// Vertices expanded from two starts, by A* and by Dijkstra.
TEST(Counts, OfShortestRoutes) {
  std::string counts;
  for (const char* file : {"grid", "jelly", "l"}) {
    const Map map = shipped(file);
    ltl::Arena arena(map.vocabulary());
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F (chair & X F (sofa & X moved))", arena));
    const std::vector<PoseId> starts{PoseId{5}, PoseId{90}};
    const MapProduct product = compose(map, dfa, starts);
    for (const auto algorithm : {ShortestRoute::Algorithm::AStar, ShortestRoute::Algorithm::Dijkstra})
      counts += std::to_string(std::get<Solved>(solve(product, ShortestRoute{.algorithm = algorithm})).expanded) + ' ';
  }
  EXPECT_EQ(counts, "54 312 12 440 100 392 ");
}

}  // namespace
}  // namespace waymark::plan
