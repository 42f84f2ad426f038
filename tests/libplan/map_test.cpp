#include "libplan/world/map.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "libplan/model/map_mdp.hpp"
#include "libplan/world/trajectory.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

TEST(Map, ForwardFollowsTheHeadingAndWallsStopIt) {
  const Map map = plus();
  EXPECT_EQ(map.successor(pose_at(map, 1, 1, 0), Action::Forward), pose_at(map, 1, 0, 0));
  EXPECT_EQ(map.successor(pose_at(map, 1, 1, 90), Action::Forward), pose_at(map, 2, 1, 90));
  EXPECT_EQ(map.successor(pose_at(map, 1, 1, 180), Action::Forward), pose_at(map, 1, 2, 180));
  EXPECT_EQ(map.successor(pose_at(map, 1, 1, 270), Action::Forward), pose_at(map, 0, 1, 270));
  EXPECT_EQ(map.successor(pose_at(map, 1, 0, 0), Action::Forward), std::nullopt);
  EXPECT_EQ(map.successor(pose_at(map, 1, 0, 180), Action::Forward), pose_at(map, 1, 1, 180));
}

TEST(Map, LeftThenRightIsNothingAndFourLeftsAreATurnRound) {
  const Map map = shipped("jelly");
  for (std::uint32_t i = 0; i < map.poses(); ++i) {
    const PoseId p{i};
    EXPECT_EQ(map.successor(*map.successor(p, Action::Left), Action::Right), p);
    PoseId turned = p;
    for (int k = 0; k < 4; ++k) turned = *map.successor(turned, Action::Left);
    EXPECT_EQ(turned, p);
    EXPECT_EQ(map.pose(*map.successor(p, Action::Right)).heading, (map.pose(p).heading + 90) % 360);
  }
}

TEST(Map, EveryHallwayCanBeWalkedBothWays) {
  for (const char* file : {"grid", "jelly", "l"}) {
    const Map map = shipped(file);
    std::size_t moves = 0;
    for (std::uint32_t i = 0; i < map.poses(); ++i) {
      const auto next = map.successor(PoseId{i}, Action::Forward);
      if (!next) continue;
      ++moves;
      const Pose there = map.pose(*next);
      const auto back = map.successor(*map.find({there.x, there.y, (there.heading + 180) % 360}), Action::Forward);
      ASSERT_TRUE(back);
      EXPECT_EQ(map.node_of(*back), map.node_of(PoseId{i}));
    }
    EXPECT_EQ(moves, 2 * map.edges().size());
  }
}

TEST(Map, FindIsTheInverseOfPose) {
  const Map map = shipped("l");
  for (std::uint32_t i = 0; i < map.poses(); ++i) EXPECT_EQ(map.find(map.pose(PoseId{i})), PoseId{i});
  EXPECT_EQ(map.find({9, 9, 0}), std::nullopt);
  for (int heading : {-1, 45, 360, -90}) EXPECT_EQ(map.find({19, 23, heading}), std::nullopt) << heading;
}

TEST(Map, LettersAreLabelsPlusTheEventOfTheAction) {
  const Map map = square();
  const char* const events[] = {"moved", "turned_left", "turned_right"};
  for (std::uint32_t i = 0; i < map.poses(); ++i) {
    for (const char* event : events) EXPECT_FALSE(map.label(PoseId{i}).contains(*map.vocabulary().find(event)));
    for (std::size_t a = 0; a < all_actions.size(); ++a) {
      ltl::Letter expected = map.label(PoseId{i});
      expected.insert(*map.vocabulary().find(events[a]));
      EXPECT_EQ(map.letter(PoseId{i}, all_actions[a]), expected);
    }
  }
}

TEST(Map, EqualLettersHaveOneId) {
  for (const char* file : {"grid", "jelly", "l"}) {
    const Map map = shipped(file);
    std::set<std::pair<std::uint64_t, std::uint64_t>> distinct;
    for (const ltl::Letter& letter : map.letters().all()) distinct.insert({letter.block(0), letter.block(1)});
    ASSERT_LE(map.vocabulary().size(), 128U);
    EXPECT_EQ(distinct.size(), map.letters().size());
    EXPECT_LE(map.letters().size(), 4 * map.poses());
  }
}

// Long hallways are looked along once, not once from every place; what would not fit in memory is refused.
TEST(Map, LargeMapsAreReadOrRefused) {
  const int length = 20'000;
  const Map map = hallway(length);
  EXPECT_TRUE(map.label(pose_at(map, 0, 0, 90)).contains(*map.vocabulary().find("ahead_chair")));
  EXPECT_FALSE(map.label(pose_at(map, 0, 0, 270)).contains(*map.vocabulary().find("ahead_chair")));
  EXPECT_FALSE(map.label(pose_at(map, length, 0, 90)).contains(*map.vocabulary().find("ahead_chair")));
  std::vector<Node> nodes;
  std::vector<std::string> objects;
  for (int x = 0; x < 3000; ++x) {
    objects.push_back("thing_" + std::to_string(x));
    nodes.push_back({x, 0, objects.back(), std::nullopt});
  }
  EXPECT_THROW(Map("", nodes, {}, objects, {}, {}), std::invalid_argument);
}

TEST(Map, BadPartsAreRefusedByName) {
  const Node here{0, 0, std::nullopt, std::nullopt}, east{1, 0, std::nullopt, std::nullopt},
      far{3, 0, std::nullopt, std::nullopt}, diagonal{1, 1, std::nullopt, std::nullopt};
  const auto message = [](const std::vector<Node>& nodes, const std::vector<Edge>& edges,
                          std::vector<std::string> objects = {}, std::vector<std::string> floors = {"blue"}) {
    try {
      Map("", nodes, edges, std::move(objects), std::move(floors), {});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message({here, east}, {{0, 1, "blue", ""}}), "accepted");
  EXPECT_EQ(message({}, {}), "a map needs at least one node");
  EXPECT_EQ(message({here, here}, {}), "there is already a node at (0,0)");
  EXPECT_EQ(message({here, far}, {{0, 1, "", ""}}), "(0,0) and (3,0) are not orthogonal neighbours at distance 1");
  EXPECT_EQ(message({here, diagonal}, {{0, 1, "", ""}}), "(0,0) and (1,1) are not orthogonal neighbours at distance 1");
  EXPECT_EQ(message({here, east}, {{0, 1, "", ""}, {1, 0, "", ""}}), "(1,0) and (0,0) are already joined by an edge");
  EXPECT_EQ(message({here, east}, {{0, 2, "", ""}}), "an edge names a node that is not there");
  EXPECT_EQ(message({here, east}, {{0, 1, "red", ""}}), "the map shows 'red', which it does not list");
  EXPECT_EQ(message({here}, {}, {"corner"}), "two observables would share the proposition 'corner'");
  EXPECT_EQ(message({here}, {}, {"blue"}), "two observables would share the proposition 'blue'");
  EXPECT_EQ(message({{0, 0, std::nullopt, 0}}, {}), "places are numbered 1 to 1000");
  EXPECT_EQ(message({{2'000'000, 0, std::nullopt, std::nullopt}}, {}), "coordinates run from -1000000 to 1000000");
}

TEST(MapMdp, TurnsMayComeToNothingOrGoTooFar) {
  const Map map = plus();
  const Mdp mdp = mdp_of(map, PoseId{0}, MapNoise({}, {.stay = 0.25, .beyond = 0.125}));
  const Mdp calm = mdp_of(map, PoseId{0});
  std::size_t turns = 0;
  for (std::uint32_t p = 0; p < map.poses(); ++p)
    for (std::uint32_t k = 0; k < mdp.choices(p); ++k) {
      ASSERT_EQ(mdp.action(p, k), calm.action(p, k));
      const Action action = *parse_action(mdp.action(p, k));
      std::map<std::uint32_t, double> expected{{calm.outcomes(p, k)[0].target, 1.0}};
      if (action != Action::Forward) {
        const PoseId once = *map.successor(PoseId{p}, action);
        expected = {{once.index, 0.625}, {p, 0.25}, {map.successor(once, action)->index, 0.125}};
        ++turns;
      }
      std::map<std::uint32_t, double> found;
      for (const ModelOutcome& o : mdp.outcomes(p, k)) {
        found[o.target] += o.probability;
        EXPECT_EQ(mdp.letters()[o.letter], map.letter(PoseId{o.target}, action));
      }
      EXPECT_EQ(found, expected) << show(map.pose(PoseId{p})) << ' ' << name(action);
    }
  EXPECT_EQ(turns, 2 * map.poses());
  EXPECT_TRUE(calm.is_deterministic());
  EXPECT_THROW(mdp_of(map, PoseId{0}, MapNoise({}, {.stay = 1})), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
