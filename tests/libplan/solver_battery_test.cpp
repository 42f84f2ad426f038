// One suite that every solver passes: the same cost and the same route as the referees, on all small formulas and then
// on seeded random larger ones.
#include <gtest/gtest.h>

#include <boost/range/iterator_range.hpp>

#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/certify.hpp"
#include "libplan/least_by_progression.hpp"
#include "libplan/solve/route_planner.hpp"
#include "tests/libplan/maps.hpp"
#include "tests/libplan/solvers.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

// Every solver on one task: a route that certify accepts, or none. All the same; returned.
std::optional<Route> agreed(const Map& map, ltl::Formula f, std::span<const PoseId> starts) {
  const automata::Dfa dfa = automata::ltlf_to_dfa(f);
  std::optional<Route> first;
  bool is_first = true;
  for (const Solver& solver : all_solvers()) {
    const std::optional<Route> route = solver.route(map, dfa, starts);
    if (route) certify(*route, map, f);
    if (is_first) first = route;
    is_first = false;
    EXPECT_EQ(route.has_value(), first.has_value()) << solver.name << "  " << paste(map, f, starts);
    if (!route || !first) continue;
    EXPECT_EQ(show(*route, map), show(*first, map)) << solver.name << "  " << paste(map, f, starts);
    EXPECT_EQ(route->cost, first->cost) << solver.name << "  " << paste(map, f, starts);
  }
  return first;
}

// What `waymark verify` asks, beside the referee.
void expect_least(const Progressed& expected, const Map& map, ltl::Formula f, PoseId start) {
  const auto least = least_by_progression(f, map, {&start, 1}, {.states = 2'000});
  if (!least || expected.proof == Proof::GaveUp) return;
  ASSERT_EQ(least->actions.has_value(), expected.proof == Proof::Found) << paste(map, f, {&start, 1});
  if (!least->actions) return;
  EXPECT_EQ(*least->actions, expected.route.actions.size()) << paste(map, f, {&start, 1});
}

// Of the vertices from which nothing is accepted any more, none has an action; all others end.
TEST(ShortestRoute, PoliciesTellWhereNothingLeadsOn) {
  const Map map = hallway(3);
  ltl::Arena arena;
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("X X X chair | X X X X X chair", arena));
  const MapProduct product = compose(map, dfa, pose_at(map, 0, 0, 90));
  const Outcome outcome = solve(product, {ShortestRoute::Algorithm::Dijkstra});
  const Policy& policy = std::get<Solved>(outcome).policy;
  std::size_t lost = 0, ends = 0;
  for (const ProductState& first : boost::make_iterator_range(vertices(product))) {
    ProductState at = first;
    std::size_t steps = 0;
    for (; policy.action[product.index(at)] && steps <= num_vertices(product); ++steps)
      for (auto [e, end] = out_edges(at, product); e != end; ++e)
        if (product.action(*e) == policy.action[product.index(at)]) {
          at = e->to;
          break;
        }
    EXPECT_TRUE(product.is_accepting(at) || steps == 0) << steps << " steps";
    ++(product.is_accepting(at) ? ends : lost);
  }
  EXPECT_GT(lost, 0U);
  EXPECT_GT(ends, 4U);
}

TEST(RoutePlanner, MeetsEveryPoseOnce) {
  const Map map = hallway(40);
  ltl::Arena arena;
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F sofa", arena));
  RoutePlanner planner(map, dfa);
  ASSERT_TRUE(std::holds_alternative<Infeasible>(planner.plan(pose_at(map, 0, 0, 90))));
  EXPECT_EQ(planner.met(), map.poses());
}

TEST(SolverBattery, AllSmallFormulasAgainstEnumeration) {
  constexpr std::size_t length = 5;
  for (const Map& map : {hallway(2), square(), plus()}) {
    ltl::Arena arena(ltl::Vocabulary({"sofa", "moved"}));
    for (ltl::Formula f : testing::all_formulas(arena, {.size = testing::sanitized ? 3U : 4U, .atoms = 2})) {
      for (const PoseId start : {PoseId{0}, PoseId{9}}) {
        const auto route = agreed(map, f, {&start, 1});
        const auto expected = by_enumeration(map, f, start, length);
        if (expected) {
          ASSERT_TRUE(route) << paste(map, f, {&start, 1});
          ASSERT_EQ(show(*route, map), show(*expected, map)) << paste(map, f, {&start, 1});
        } else if (route) {
          ASSERT_GT(route->actions.size(), length) << paste(map, f, {&start, 1});
        }
      }
    }
  }
}

TEST(SolverBattery, RandomFormulasAgainstProgression) {
  constexpr std::uint64_t seed = 20240611;
  ltl::Random random(seed);
  const std::vector<std::string> names = {"moved", "sofa",        "ahead_chair", "corner",       "blue",
                                          "tee",   "turned_left", "ahead_wall",  "intersection", "place_1"};
  std::size_t found = 0, none = 0, gave_up = 0;
  for (const char* file : {"grid", "jelly", "l"}) {
    const Map map = shipped(file);
    for (int round = 0; round < 80; ++round) {
      ltl::Vocabulary vocabulary;
      for (int k = 0; k < 3; ++k) vocabulary.add(names[random.below(names.size())]);
      const std::size_t atoms = vocabulary.size();
      ltl::Arena arena(std::move(vocabulary));
      const ltl::Formula f = ltl::random_formula(random, arena, {.size = 4 + random.below(10), .atoms = atoms});
      const PoseId start{static_cast<std::uint32_t>(random.below(map.poses()))};
      const auto route = agreed(map, f, {&start, 1});
      const Progressed expected = by_progression(map, f, start, 600);
      expect_least(expected, map, f, start);
      switch (expected.proof) {
        case Proof::Found:
          ++found;
          ASSERT_TRUE(route) << "seed " << seed << "  " << paste(map, f, {&start, 1});
          EXPECT_EQ(show(*route, map), show(expected.route, map))
              << "seed " << seed << "  " << paste(map, f, {&start, 1});
          break;
        case Proof::None:
          ++none;
          EXPECT_FALSE(route) << "seed " << seed << "  " << paste(map, f, {&start, 1});
          break;
        case Proof::GaveUp: ++gave_up; break;
      }
    }
  }
  EXPECT_GT(found, 130U);
  EXPECT_GT(none, 14U);
  EXPECT_LT(gave_up, 24U) << found << " found, " << none << " proved infeasible";
}

// The shape of route programs: nested reach-then-reach tasks, whose plans are long and full of ties.
TEST(SolverBattery, NestedTasksAgainstProgression) {
  const char* formulas[] = {
      "F (sofa & X F (chair & X F lamp))",
      "F (corner & F (easel & F (hatrack & F barstool)))",
      "X(moved U (moved & intersection)) & F(place_3 & F place_1)",
      "G !blue & F (grass & ahead_wall)",
      "F (moved & X (turned_left & X (moved & X (turned_right & X moved))))",
      "(!chair U sofa) & F (lamp & X[w] false)",
      "F place_1 & F place_2 & F place_3 & F place_4",
      "G (moved -> X !turned_left) & F (place_5 & dead_end | place_6)",
  };
  for (const char* file : {"grid", "jelly", "l"}) {
    const Map map = shipped(file);
    ltl::Arena arena(map.vocabulary());
    for (const char* text : formulas) {
      const ltl::Formula f = ltl::parse(text, arena, {.unknown = ltl::Unknown::Reject});
      for (std::uint32_t i = 0; i < map.poses(); i += 37) {
        const PoseId start{i};
        const auto route = agreed(map, f, {&start, 1});
        const Progressed expected = by_progression(map, f, start, 200'000);
        expect_least(expected, map, f, start);
        ASSERT_NE(expected.proof, Proof::GaveUp) << paste(map, f, {&start, 1});
        ASSERT_EQ(route.has_value(), expected.proof == Proof::Found) << paste(map, f, {&start, 1});
        if (!route) continue;
        EXPECT_EQ(show(*route, map), show(expected.route, map)) << paste(map, f, {&start, 1});
      }
    }
  }
}

// A planner that has answered before answers the same as one that has not.
TEST(SolverBattery, APlannerMayBeAskedAgain) {
  const Map map = shipped("jelly");
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula f = ltl::parse("F (chair & X F (ahead_sofa & X moved))", arena);
  const automata::Dfa dfa = automata::ltlf_to_dfa(f);
  RoutePlanner planner(map, dfa);
  for (int round = 0; round < 2; ++round) {
    for (std::uint32_t i = 0; i < map.poses(); ++i) {
      const auto again = planner.plan(PoseId{i});
      const auto fresh = RoutePlanner(map, dfa).plan(PoseId{i});
      ASSERT_TRUE(std::holds_alternative<Route>(again));
      EXPECT_EQ(std::get<Route>(again).actions, std::get<Route>(fresh).actions) << show(map.pose(PoseId{i}));
    }
  }
}

TEST(SolverBattery, OfStartsTheNearestIsTakenAndOfEqualOnesTheFirst) {
  const Map map = hallway(6);
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula f = ltl::parse("F chair", arena);
  const auto east = [&](int x) { return pose_at(map, x, 0, 90); };
  const auto west = [&](int x) { return pose_at(map, x, 0, 270); };
  const std::vector<PoseId> different{west(5), east(3), east(4), east(1)}, same{west(4), east(3), west(5), east(2)};
  for (const auto& [starts, first] : {std::pair{different, east(4)}, std::pair{same, east(3)}}) {
    const auto route = agreed(map, f, starts);
    ASSERT_TRUE(route);
    EXPECT_EQ(show(map.pose(route->poses.front())), show(map.pose(first)));
  }
  const std::vector<PoseId> equal{west(4), east(2)};  // two turns and two moves, four moves
  EXPECT_EQ(agreed(map, f, equal)->poses.front(), equal.front());
}

// More poses than 64 times as many words as bits of a word: a row of bits each for what is left of the task.
TEST(SolverBattery, ALongHallwayIsWalkedUpAndDown) {
  const Map map = hallway(1'100);
  ltl::Arena arena(map.vocabulary());
  const PoseId start = pose_at(map, 0, 0, 90);
  const auto route = agreed(map, ltl::parse("F (chair & F (blue & F chair))", arena), {&start, 1});
  ASSERT_TRUE(route);
  EXPECT_NEAR(route->cost, 3 * 1'100 + 2 + 2, 4);
}

TEST(SolverBattery, StopsBeforeItLooksAtAnything) {
  const Map map = hallway(2);
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F chair", arena));
  std::stop_source source;
  source.request_stop();
  const PoseId start = pose_at(map, 0, 0, 90);
  const auto planned = RoutePlanner(map, dfa).plan({&start, 1}, source.get_token());
  ASSERT_TRUE(std::holds_alternative<Exhausted>(planned));
  EXPECT_EQ(std::get<Exhausted>(planned).states, 0U);
}

TEST(SolverBattery, SaysWhetherItIsTheTaskOrTheMap) {
  const Map map = hallway(2);
  ltl::Arena arena(map.vocabulary());
  const auto reason = [&](const char* formula) {
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(formula, arena));
    return std::get<Infeasible>(RoutePlanner(map, dfa).plan(pose_at(map, 0, 0, 90))).reason;
  };
  EXPECT_EQ(reason("F (sofa & !sofa)"), "no finite word satisfies the task");
  EXPECT_EQ(reason("F sofa"),
            "no route from here satisfies the task (all 12 reachable pairs of pose and state were searched)");
}

}  // namespace
}  // namespace waymark::plan
