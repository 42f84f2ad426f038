#include "libplan/world/labelling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

std::vector<std::string> label_names(const Map& map, int x, int y, int heading) {
  std::vector<std::string> names;
  for (ltl::Proposition p : map.label(pose_at(map, x, y, heading)).members()) names.push_back(map.vocabulary().name(p));
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

TEST(Labelling, SeesObjectsAlongTheHallwayFloorsAndPaintingsOfTheNextSegment) {
  const Map map = hallway(3);  // blue, brick, brick; the chair stands at (3,0)
  EXPECT_EQ(label_names(map, 0, 0, 90), (Names{"ahead_blue", "ahead_chair", "ahead_fish", "ahead_open", "behind_wall",
                                               "blue", "dead_end", "left_wall", "next_corridor", "right_wall"}));
  EXPECT_EQ(label_names(map, 1, 0, 180),
            (Names{"ahead_wall", "behind_wall", "blue", "brick", "corridor", "left_brick", "left_chair", "left_fish",
                   "left_open", "right_blue", "right_fish", "right_open"}));
  EXPECT_EQ(label_names(map, 2, 0, 90),
            (Names{"ahead_brick", "ahead_chair", "ahead_fish", "ahead_open", "behind_brick", "behind_fish",
                   "behind_open", "brick", "corridor", "left_wall", "next_chair", "next_dead_end", "right_wall"}));
  // What stands here is not ahead.
  EXPECT_EQ(label_names(map, 3, 0, 90), (Names{"ahead_wall", "behind_brick", "behind_fish", "behind_open", "brick",
                                               "chair", "dead_end", "left_wall", "right_wall"}));
}

TEST(Labelling, KindsOfPlaceFollowFromTheOpenWays) {
  const Map cross = plus();
  const auto has = [](const Names& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const Names centre = label_names(cross, 1, 1, 0);
  EXPECT_TRUE(has(centre, "intersection"));
  EXPECT_FALSE(has(centre, "tee"));
  EXPECT_TRUE(has(label_names(cross, 1, 0, 0), "dead_end"));
  EXPECT_TRUE(has(label_names(cross, 1, 0, 180), "next_intersection"));
  EXPECT_TRUE(has(label_names(cross, 1, 0, 0), "place_1"));
  EXPECT_TRUE(has(label_names(square(), 0, 0, 0), "corner"));
  EXPECT_TRUE(has(label_names(hallway(2), 1, 0, 0), "corridor"));
  const Map tee("", {{0, 0, {}, {}}, {1, 0, {}, {}}, {2, 0, {}, {}}, {1, 1, {}, {}}},
                {{0, 1, "", ""}, {1, 2, "", ""}, {1, 3, "", ""}}, {}, {}, {});
  const Names three = label_names(tee, 1, 0, 0);
  EXPECT_TRUE(has(three, "tee"));
  EXPECT_TRUE(has(three, "intersection"));
  const Map alone("", {{0, 0, {}, {}}}, {}, {}, {}, {});
  EXPECT_EQ(label_names(alone, 0, 0, 0), (Names{"ahead_wall", "behind_wall", "left_wall", "right_wall"}));
}

TEST(Labelling, TheThreeSailMapsShareOneVocabulary) {
  const Map grid = shipped("grid"), jelly = shipped("jelly"), l = shipped("l");
  EXPECT_EQ(grid.vocabulary(), jelly.vocabulary());
  EXPECT_EQ(grid.vocabulary(), l.vocabulary());
  for (const char* name : {"chair", "blue", "intersection", "tee", "corner", "corridor", "dead_end", "place_3",
                           "ahead_chair", "left_brick", "behind_fish", "right_wall", "ahead_open", "next_chair",
                           "next_corner", "moved", "turned_left", "turned_right"})
    EXPECT_TRUE(grid.vocabulary().find(name)) << name;
  EXPECT_FALSE(grid.vocabulary().find("fish"));  // paintings hang along a segment, never at a place
}

// Seen the same from everywhere: turning round moves `ahead` to `right`, `right` to `behind`, …
TEST(Labelling, TurningLeftMovesEverythingSeenOneQuarterRight) {
  for (const char* file : {"grid", "jelly", "l"}) {
    const Map map = shipped(file);
    const ltl::Vocabulary& names = map.vocabulary();
    for (std::uint32_t i = 0; i < map.poses(); ++i) {
      const ltl::Letter& before = map.label(PoseId{i});
      const ltl::Letter& after = map.label(*map.successor(PoseId{i}, Action::Left));
      for (ltl::Proposition p : before.members()) {
        const std::string& name = names.name(p);
        std::string expected = name;
        const std::pair<std::string, std::string> turns[] = {
            {"ahead_", "right_"}, {"right_", "behind_"}, {"behind_", "left_"}, {"left_", "ahead_"}};
        for (const auto& [from, to] : turns)
          if (name.starts_with(from)) expected = to + name.substr(from.size());
        if (name.starts_with("next_")) continue;  // belongs to the heading alone
        EXPECT_TRUE(after.contains(*names.find(expected))) << file << " " << show(map.pose(PoseId{i})) << " " << name;
      }
    }
  }
}

}  // namespace
}  // namespace waymark::plan
