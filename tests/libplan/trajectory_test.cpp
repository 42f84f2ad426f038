#include "libplan/world/trajectory.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

using enum Action;

TEST(Trajectory, JsonAndActionListReadTheSame) {
  const Map map = square();
  const Trajectory expected{
      {pose_at(map, 0, 0, 0), pose_at(map, 0, 0, 90), pose_at(map, 1, 0, 90), pose_at(map, 1, 0, 180)},
      {Right, Forward, Right}};
  EXPECT_EQ(parse_trajectory("[[0,0,0],[0,0,90],[1,0,90],[1,0,180]]", map), expected);
  EXPECT_EQ(parse_trajectory(R"( {"cost": 3, "route": [[0,0,0],[0,0,90],[1,0,90],[1,0,180]]})", map), expected);
  EXPECT_EQ(parse_trajectory("0,0,0 RIGHT FORWARD RIGHT", map), expected);
  EXPECT_EQ(parse_trajectory("# out of the corner\n0,0,0\nright, f # one step\nR\n", map), expected);
  EXPECT_EQ(parse_trajectory(show(expected, map), map), expected);
  EXPECT_EQ(parse_trajectory("[[0,0,270]]", map), (Trajectory{{pose_at(map, 0, 0, 270)}, {}}));
}

TEST(Trajectory, FaultsNameTheStep) {
  const Map map = square();
  const std::pair<const char*, const char*> table[] = {
      {"[[0,0,0],\n [1,0,0]]",
       "[1]: no single action leads from (0,0,0) to (1,0,0); FORWARD meets a wall, LEFT leads to (0,0,270), "
       "RIGHT leads "
       "to (0,0,90)\n  t:2:2"},
      {"[[0,0,0],[0,0,0]]",
       "[1]: no single action leads from (0,0,0) to (0,0,0); FORWARD meets a wall, LEFT leads to (0,0,270), "
       "RIGHT leads "
       "to (0,0,90)\n  t:1:10"},
      {"[[9,9,0]]", "[0]: (9,9) is no place of square; the nearest is (1,1)\n  t:1:2"},
      {"[[0,0,-1]]", "[0]: (0,0,-1): the heading must be 0, 90, 180 or 270, clockwise from north\n  t:1:2"},
      {"[]", "a trajectory needs at least one pose\n  t:1:1"},
      {"{\"route\": 5}", "route: expected a list of poses [x,y,heading]\n  t:1:11"},
      {"{\"route\": [[0,0,0]], \"cycle\": -7}", "cycle: expected a list of poses [x,y,heading]\n  t:1:31"},
      {"{\"prefix\": [[0,0,0]], \"cycle\": -7}", "cycle: expected a list of poses [x,y,heading]\n  t:1:32"},
      {"{\"rout\": []}", "expected a list of poses [x,y,heading]\n  t:1:1"},
      {"[[0,0]]", "[0]: expected a pose [x,y,heading]\n  t:1:2"},
      {"[[0,0.5,90]]", "[0][1]: expected a whole number\n  t:1:5"},
      {"[[0,0,1e300]]", "[0][2]: expected a whole number\n  t:1:7"},
      {"", "expected a start pose x,y,heading and actions\n  t:1:1"},
      {"FORWARD", "expected a start pose x,y,heading, found 'FORWARD'\n  t:1:1"},
      {"0,0,0 RIGHT\nJUMP", "expected FORWARD, LEFT or RIGHT, found 'JUMP'\n  t:2:1"},
      {"0,0,0 LEFT FORWARD", "FORWARD meets a wall at (0,0,270)\n  t:1:12"},
  };
  for (const auto& [text, expected] : table) {
    try {
      parse_trajectory(text, map, "t");
      ADD_FAILURE() << "accepted: " << text;
    } catch (const ltl::FormatError& error) {
      EXPECT_STREQ(error.what(), expected) << text;
    }
  }
  try {
    parse_trajectory("[[0,0,0]", map, "t");
    ADD_FAILURE() << "accepted half a list";
  } catch (const ltl::FormatError& error) {
    EXPECT_EQ(std::string(error.what()).find("malformed JSON: "), 0U) << error.what();
    EXPECT_EQ(error.column(), 9U);
  }
}

TEST(Trajectory, StartPosesMayLeaveTheHeadingOpen) {
  const Map map = square();
  EXPECT_EQ(parse_start("1,1,270", map), std::vector<PoseId>{pose_at(map, 1, 1, 270)});
  const std::vector<PoseId> all{pose_at(map, 1, 1, 0), pose_at(map, 1, 1, 90), pose_at(map, 1, 1, 180),
                                pose_at(map, 1, 1, 270)};
  EXPECT_EQ(parse_start("1,1", map), all);
  EXPECT_EQ(parse_start("1,1,-1", map), all);
  for (const char* bad : {"", "1", "1,1,45", "1,1,0,0", "a,b,c", "2,2,0", "1, 1, 0", "99999999999,0,0"})
    EXPECT_THROW(parse_start(bad, map), ltl::FormatError) << bad;
}

TEST(Trajectory, FollowStopsAtWalls) {
  const Map map = hallway(2);
  const PoseId start = pose_at(map, 0, 0, 90);
  ASSERT_TRUE(follow(map, start, {Forward, Forward}));
  EXPECT_EQ(follow(map, start, {Forward, Forward})->poses.back(), pose_at(map, 2, 0, 90));
  EXPECT_EQ(follow(map, start, {Forward, Forward, Forward}), std::nullopt);
}

TEST(Trajectory, ActionsAreRecoveredFromPoses) {
  const Map map = shipped("jelly");
  for (std::uint32_t i = 0; i < map.poses(); ++i) {
    for (Action action : all_actions) {
      const auto next = map.successor(PoseId{i}, action);
      if (next) {
        EXPECT_EQ(action_between(map, PoseId{i}, *next), action);
      }
    }
  }
}

}  // namespace
}  // namespace waymark::plan
