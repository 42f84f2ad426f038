#include "libparser/domain/streets/naming_habits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libparser/domain/streets/pragmatic_features.hpp"
#include "libparser/domain/streets/route_prior.hpp"
#include "tests/libparser/domain/streets/town.hpp"

namespace waymark::streets {
namespace {

TEST(RoutePrior, RanksOfOneGoalAreOneDistribution) {
  constexpr std::size_t most = 40;
  for (std::size_t routes = 1; routes < most; ++routes) {
    double sum = 0;
    for (std::size_t rank = 0; rank < routes; ++rank) sum += rank_probability(rank, routes, most);
    EXPECT_NEAR(sum, 1, 1e-12) << routes;
    EXPECT_EQ(rank_probability(routes - 1, routes, most), routes > 1 ? 0 : 1);  // the last has no rival
  }
  EXPECT_DOUBLE_EQ(rank_probability(2, most, most), 0.2 * 0.8 * 0.8);
  EXPECT_DOUBLE_EQ(rank_probability(2, 4, most), 0.8 * 0.8);
}

// a — b — c: there is one route to every goal.
StreetMap line() {
  return parse_street_map(R"({"name": "line", "nodes": [{"id": 0, "name": "A", "u": 0, "v": 0},
    {"id": 1, "name": "B", "u": 1, "v": 0}, {"id": 2, "name": "C", "u": 2, "v": 0}],
    "edges": [{"a": 0, "b": 1, "length": 1}, {"a": 1, "b": 2, "length": 1}]})");
}

TEST(NamingHabits, NamesOverRoutesThatShouldPass) {
  const StreetMap map = line();
  RouteTable routes(map, 10);
  // Of two routes from A both should pass B, one C. B is named once.
  const std::vector<UnreadText> texts{{0, {0, 1}}, {0, {2}}};
  const NamingHabits habits = naming_habits(map, routes, texts);
  ASSERT_TRUE(habits.known());
  EXPECT_DOUBLE_EQ(habits.usual_named, 2.0 / 3);
  EXPECT_DOUBLE_EQ(habits.named[0], habits.usual_named);  // its own start is not named
  EXPECT_DOUBLE_EQ(habits.named[1], (1 + 10 * 2.0 / 3) / (2 + 10));
  EXPECT_DOUBLE_EQ(habits.named[2], (1 + 10 * 2.0 / 3) / (1 + 10));
  // A to B is said once of two times; B to C never; A to C is no way.
  EXPECT_DOUBLE_EQ(habits.usual_said, 1.0 / 3);
  EXPECT_EQ(habits.said.size(), 2U);
  EXPECT_DOUBLE_EQ(habits.said.at({0, 1}), (1 + 10 / 3.0) / (2 + 10));
  EXPECT_DOUBLE_EQ(habits.said.at({1, 2}), (10 / 3.0) / (1 + 10));
}

TEST(NamingHabits, WhatIsLeftOutOrNamedForOthersStandsOut) {
  const StreetMap map = town();
  RouteTable routes(map, 10);
  // Every route, as often as it should be shown; whoever passes the wall's neighbour names the wall.
  std::vector<UnreadText> texts;
  for (LandmarkIndex start = 0; start < map.landmarks.size(); ++start)
    for (LandmarkIndex goal = 0; goal < map.landmarks.size(); ++goal) {
      if (goal == start) continue;
      const auto& ranked = routes.routes(start, goal);
      for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
        UnreadText text{start, ranked[rank].landmarks};
        for (LandmarkIndex& l : text.named)
          if (l == new_mill) l = wall;
        const double times = 100 * rank_probability(rank, ranked.size(), routes.most());
        for (int i = 0; i < std::lround(times); ++i) texts.push_back(text);
      }
    }
  const NamingHabits habits = naming_habits(map, routes, texts);
  EXPECT_LT(habits.named[new_mill], 0.05);
  EXPECT_GT(habits.named[wall], 1.5);
  for (const LandmarkIndex l : {church, bakery, old_mill, museum, cafe, well})
    EXPECT_NEAR(habits.named[l], 1, 0.05) << l;
  EXPECT_LT(habits.said.at({old_mill, new_mill}), 0.05);
  EXPECT_NEAR(habits.said.at({church, bakery}), 1, 0.05);
}

// Old mill → new mill → wall, told as "to the wall", in a city that names the new mill a tenth as often as other landmarks.
TEST(NamingHabits, MakeItUsualToLeaveOutWhatIsSeldomNamed) {
  const StreetMap map = town();
  const std::vector<std::string> tokens{"to", "wall"};
  const std::vector<Mention> mentions{{1, 2, {{wall, 4, 1}}}};
  const std::vector<MentionCue> cues(1);
  CandidateRoute route;
  route.landmarks = {old_mill, new_mill, wall};
  NamingHabits habits;
  habits.named.assign(map.landmarks.size(), 1.0);
  habits.said[{old_mill, new_mill}] = habits.said[{new_mill, wall}] = 1;
  const auto odds = [&](unsigned which) {
    FeatureList list, wanted;
    wanted.add(FeatureKind::Habit, 1, which);
    const std::uint32_t index = wanted.take()[0].index;
    add_habits(list, {map, 1, tokens, mentions, cues, route, place(mentions, route.landmarks), &habits});
    double sum = 0;
    for (const WeighedFeature& f : list.take()) sum += f.index == index ? static_cast<double>(f.value) : 0;
    return sum;
  };
  constexpr unsigned named = 1, left_out = 2, not_said = 6;
  for (const unsigned which : {named, left_out, not_said}) EXPECT_NEAR(odds(which), 0, 1e-6) << which;
  habits.named[new_mill] = 0.1;
  EXPECT_NEAR(odds(named), 0, 1e-6);  // the wall is
  EXPECT_NEAR(odds(left_out), std::log((1 - 0.095) / 0.05), 1e-5);
  habits.said[{new_mill, wall}] = 0.5;
  EXPECT_NEAR(odds(not_said), std::log((1 - 0.45) / 0.1), 1e-5);
}

TEST(NamingHabits, AreKnownOfTextsThatNameNothing) {
  const StreetMap map = line();
  RouteTable routes(map, 10);
  const std::vector<UnreadText> texts{{0, {}}};
  const NamingHabits habits = naming_habits(map, routes, texts);
  for (const double rate : habits.named) EXPECT_EQ(rate, 0);
  EXPECT_EQ(habits.usual_named, 0);
  EXPECT_EQ(naming_habits(map, routes, {}).usual_named, 1);
}

}  // namespace
}  // namespace waymark::streets
