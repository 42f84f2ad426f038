#include "libplan/solve/lower_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/range/iterator_range.hpp>
#include <cmath>
#include <limits>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/product/compose.hpp"
#include "tests/libplan/maps.hpp"
#include "tests/libplan/solvers.hpp"

namespace waymark::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<PoseId> every_pose(const Map& map) {
  std::vector<PoseId> out;
  for (std::uint32_t i = 0; i < map.poses(); ++i) out.push_back({i});
  return out;
}

// Cost to acceptance by vertex: value iteration to the fixed point, slow and obvious.
std::vector<double> true_costs(const MapProduct& product) {
  std::vector<double> cost(num_vertices(product), infinity);
  for (bool changed = true; changed;) {
    changed = false;
    for (const ProductState& v : boost::make_iterator_range(vertices(product))) {
      double best = product.is_accepting(v) ? 0 : infinity;
      for (auto [e, end] = out_edges(v, product); e != end; ++e)
        best = std::min(best, product.cost(*e) + cost[product.index(target(*e, product))]);
      if (product.is_accepting(v)) best = 0;
      double& known = cost[product.index(v)];
      if (best < known) changed = true;
      known = std::min(known, best);
    }
  }
  return cost;
}

void check(const Map& map, ltl::Formula f) {
  const automata::Dfa dfa = automata::ltlf_to_dfa(f);
  const std::vector<PoseId> starts = every_pose(map);
  const MapProduct product = compose(map, dfa, starts);
  const std::vector<double> costs = true_costs(product);
  TaskSteps steps(map, dfa);
  LowerBound bound(steps);
  for (const ProductState& v : boost::make_iterator_range(vertices(product))) {
    const double h = bound(v);
    const PoseId pose{v.place};
    ASSERT_LE(h, costs[product.index(v)]) << "not admissible: " << paste(map, f, {&pose, 1});
    ASSERT_GE(h, product.is_trap(v) ? infinity : dfa.distance_to_acceptance(automata::StateId{v.task}));
    if (product.is_accepting(v)) continue;  // never expanded by a search
    for (auto [e, end] = out_edges(v, product); e != end; ++e)
      ASSERT_LE(h, product.cost(*e) + bound(target(*e, product))) << "not consistent: " << paste(map, f, {&pose, 1});
  }
}

TEST(LowerBound, IsAdmissibleAndConsistent) {
  constexpr std::uint64_t seed = 11;
  ltl::Random random(seed);
  for (const Map& map : {hallway(3), square(), plus(), shipped("grid")}) {
    for (int round = 0; round < 40; ++round) {
      ltl::Arena arena(ltl::Vocabulary({"sofa", "moved", "ahead_wall"}));
      check(map, ltl::random_formula(random, arena, {.size = 3 + random.below(10), .atoms = 3}));
    }
  }
}

TEST(LowerBound, IsExactForOneReachStep) {
  const Map map = shipped("jelly");
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F sofa", arena));
  const std::vector<PoseId> starts = every_pose(map);
  const MapProduct product = compose(map, dfa, starts);
  const std::vector<double> costs = true_costs(product);
  TaskSteps steps(map, dfa);
  LowerBound bound(steps);
  for (const ProductState& v : boost::make_iterator_range(vertices(product)))
    EXPECT_EQ(bound(v), costs[product.index(v)]);
}

// Rings in a row, each with two ways round it that are as long: 2^rings shortest ways, which cannot be followed one by
// one.
TEST(LowerBound, IsExactWhereVeryManyWaysAreAsShort) {
  constexpr int rings = 30;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  for (int i = 0; i < rings; ++i) {
    const auto west = static_cast<std::uint32_t>(nodes.size()), east = west + 4;
    const std::array<std::array<int, 2>, 8> round{{{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}, {2, -1}, {1, -1}, {0, -1}}};
    for (const auto& [x, y] : round) nodes.push_back({3 * i + x, y, std::nullopt, std::nullopt});
    for (std::uint32_t k = 0; k < 8; ++k) edges.push_back({west + k, west + (k + 1) % 8, "blue", ""});
    if (i + 1 < rings) edges.push_back({east, west + 8, "blue", ""});
  }
  nodes[nodes.size() - 4].object = "sofa";  // in the east of the last one
  const Map map("rings", nodes, edges, {"sofa"}, {"blue"}, {"fish"});
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F sofa", arena));
  TaskSteps steps(map, dfa);
  LowerBound bound(steps);
  const std::vector<PoseId> starts = every_pose(map);
  const MapProduct product = compose(map, dfa, starts);
  const std::vector<double> costs = true_costs(product);
  for (const ProductState& v : boost::make_iterator_range(vertices(product)))
    EXPECT_EQ(bound(v), costs[product.index(v)]);
}

TEST(LowerBound, SavesExpansions) {
  const Map map = shipped("jelly");
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F (chair & F (sofa & F place_1))", arena));
  std::size_t by_a_star = 0, by_dijkstra = 0;
  for (PoseId start : every_pose(map)) {
    const MapProduct product = compose(map, dfa, start);
    const Outcome a_star = solve(product, {.algorithm = ShortestRoute::Algorithm::AStar});
    const Outcome dijkstra = solve(product, {.algorithm = ShortestRoute::Algorithm::Dijkstra});
    by_a_star += std::get<Solved>(a_star).expanded;
    by_dijkstra += std::get<Solved>(dijkstra).expanded;
  }
  EXPECT_LT(2 * by_a_star, by_dijkstra);
}

}  // namespace
}  // namespace waymark::plan
