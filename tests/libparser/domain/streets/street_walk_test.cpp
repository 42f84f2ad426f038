#include "libparser/domain/streets/street_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "libparser/domain/streets/pragmatic_features.hpp"
#include "tests/libparser/domain/streets/town.hpp"

namespace waymark::streets {
namespace {

CandidateRoute candidate(StreetRoute route, StreetRoute rival = {}) {
  CandidateRoute out;
  out.landmarks = std::move(route);
  out.rival = std::move(rival);
  return out;
}

std::vector<PlacedMention> said(const StreetRoute& names, const StreetRoute& route) {
  std::vector<PlacedMention> out;
  for (const LandmarkIndex name : names) {
    const auto at = std::find(route.begin(), route.end(), name);
    const bool on = at != route.end();
    out.push_back({name, on ? static_cast<std::uint32_t>(at - route.begin()) : off_route, 4, 1});
  }
  return out;
}

TEST(StreetWalk, SaysWhatEveryMentionIs) {
  const CandidateRoute route = candidate({church, cafe, well, bakery}, {church, bakery, well, new_mill});
  const struct {
    StreetRoute names;
    std::vector<MentionRole> steps;
    std::size_t unreached;
    bool reaches_goal;
  } rows[] = {
      {{cafe, well, bakery}, {MentionRole::GoesOn, MentionRole::GoesOn, MentionRole::GoesOn}, 0, true},
      {{church, cafe, cafe}, {MentionRole::Stays, MentionRole::GoesOn, MentionRole::Stays}, 2, false},
      {{bakery, cafe, well, bakery},
       {MentionRole::Ahead, MentionRole::GoesOn, MentionRole::GoesOn, MentionRole::GoesOn},
       0,
       true},
      {{cafe, well, cafe, church, bakery},
       {MentionRole::GoesOn, MentionRole::GoesOn, MentionRole::Behind, MentionRole::AtStart, MentionRole::GoesOn},
       0,
       true},
      {{cafe, new_mill, wall, bakery},
       {MentionRole::GoesOn, MentionRole::OnRival, MentionRole::Unseen, MentionRole::GoesOn},
       1,
       true},
      {{}, {}, 3, false},
  };
  for (const auto& row : rows) {
    const Walk walk = walk_along(route, said(row.names, route.landmarks));
    EXPECT_EQ(walk.steps, row.steps);
    EXPECT_EQ(walk.unreached, row.unreached);
    EXPECT_EQ(walk.reaches_goal, row.reaches_goal);
  }
}

// Of all ways to call some mentions steps, such that steps lead along the route only, the least cost.
double least_cost(const std::vector<PlacedMention>& mentions, std::size_t positions) {
  double least = 1e9;
  for (unsigned steps = 0; steps < 1U << mentions.size(); ++steps) {
    std::vector<bool> reached(positions, false);
    reached[0] = true;
    std::uint32_t at = 0;
    bool along = true;
    double cost = 0;
    for (std::size_t i = 0; i < mentions.size(); ++i) {
      if ((steps >> i & 1U) == 0) {
        cost += cost_no_step;
        continue;
      }
      along = along && mentions[i].position != off_route && mentions[i].position >= at;
      if (!along) break;
      reached[at = mentions[i].position] = true;
    }
    if (!along) continue;
    cost += cost_unreached * static_cast<double>(std::count(reached.begin(), reached.end(), false));
    least = std::min(least, cost);
  }
  return least;
}

TEST(StreetWalk, CostsLeastOfAll) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 500; ++round) {
    StreetRoute route(2 + random() % 5);
    for (LandmarkIndex i = 0; i < route.size(); ++i) route[i] = i;
    std::vector<PlacedMention> mentions = said({}, route);
    const std::size_t n = random() % 8;
    StreetRoute names;
    for (std::size_t i = 0; i < n; ++i) names.push_back(static_cast<LandmarkIndex>(random() % 8));
    mentions = said(names, route);
    const Walk walk = walk_along(candidate(route), mentions);
    EXPECT_NEAR(walk.cost, least_cost(mentions, route.size()), 1e-9) << "round " << round;
    // The cost is that of the steps it names.
    const auto no_steps = std::count_if(walk.steps.begin(), walk.steps.end(), [](MentionRole s) {
      return s != MentionRole::Stays && s != MentionRole::GoesOn;
    });
    EXPECT_NEAR(walk.cost,
                cost_no_step * static_cast<double>(no_steps) + cost_unreached * static_cast<double>(walk.unreached),
                1e-9)
        << "round " << round;
  }
}

TEST(StreetSight, NearnessIsThatOfThePicture) {
  const StreetMap map = town();  // 3 wide, 1 high
  EXPECT_DOUBLE_EQ(closeness(map, church, church), 0);
  EXPECT_DOUBLE_EQ(closeness(map, church, museum), 1);
  EXPECT_NEAR(closeness(map, new_mill, wall), 0.05 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(closeness(map, church, cafe), 4);  // one above the other
}

TEST(StreetSight, DistanceFromARouteIsThatFromItsNearestLeg) {
  const StreetMap map = town();
  EXPECT_DOUBLE_EQ(distance_from(map, {church, old_mill}, bakery), 0);
  EXPECT_DOUBLE_EQ(distance_from(map, {church, old_mill}, well), 1);
  EXPECT_DOUBLE_EQ(distance_from(map, {church, bakery}, museum), 2);
  EXPECT_NEAR(distance_from(map, {church, well}, cafe), std::sqrt(0.5), 1e-12);
}

// Two routes alike in the text but for what the writer can have seen do not have the same features.
TEST(StreetSight, KnowsTheRivalsLandmarksFromThoseNobodyShowed) {
  const StreetMap map = town();
  const std::vector<std::string> tokens{"to", "well", "then", "museum"};
  const std::vector<Mention> mentions{{1, 2, {{well, 4, 1}}}, {3, 4, {{museum, 6, 1}}}};
  const std::vector<MentionCue> cues(2);
  const auto sight = [&](const StreetRoute& rival) {
    const CandidateRoute route = candidate({church, bakery, well}, rival);
    FeatureList list;
    add_sight(list, {map, 1, tokens, mentions, cues, route, place(mentions, route.landmarks)});
    std::vector<std::uint64_t> keys;
    for (const parser::WeightedFeature& f : list.take()) keys.push_back(f.key);
    std::sort(keys.begin(), keys.end());
    return keys;
  };
  FeatureList unseen;
  unseen.add(FeatureKind::InSight, 1, 0, std::size_t{1});
  const std::uint64_t one_unseen = unseen.take()[0].key;
  const auto holds = [&](const std::vector<std::uint64_t>& list) {
    return std::find(list.begin(), list.end(), one_unseen) != list.end();
  };
  EXPECT_TRUE(holds(sight({church, cafe, well})));
  EXPECT_FALSE(holds(sight({church, bakery, museum, well})));
}

}  // namespace
}  // namespace waymark::streets
