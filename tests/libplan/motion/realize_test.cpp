#include "libplan/motion/realize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "tests/libplan/motion/routes.hpp"

namespace waymark::plan {
namespace {

// The motion of the route, checked: its own route is the one it was made from.
Motion realized(const Trajectory& route, const Workspace& workspace, const Sampling& sampling) {
  const auto outcome = realize(route, workspace, sampling);
  const std::string label = workspace.map().name() + " " + show(route, workspace.map());
  if (!std::holds_alternative<Motion>(outcome)) throw std::runtime_error("unreached: " + label);
  const Motion& motion = std::get<Motion>(outcome);
  expect_read_back(motion, route, workspace, label);
  EXPECT_EQ(motion.robot, sampling.robot);
  return motion;
}

TEST(Realize, EveryShortRouteOfTheSmallMaps) {
  for (const Map& map : {plus(), square(), hallway(3), past_a_sofa()}) {
    const Workspace workspace(map);
    const std::function<void(const Trajectory&)> extend = [&](const Trajectory& so_far) {
      realized(so_far, workspace, {.iterations = 400});
      if (so_far.actions.size() == 3) return;
      for (Action action : all_actions)
        if (const auto next = map.successor(so_far.poses.back(), action)) {
          Trajectory longer = so_far;
          longer.poses.push_back(*next);
          longer.actions.push_back(action);
          extend(longer);
        }
    };
    for (std::uint32_t p = 0; p < map.poses(); ++p) extend(Trajectory{{PoseId{p}}, {}});
  }
}

TEST(Realize, RandomRoutesOfTheShippedMaps) {
  std::mt19937_64 random(3);
  for (const char* name : {"grid", "jelly", "l"}) {
    const Map map = shipped(name);
    const Workspace workspace(map);
    for (double radius : {0.0, 0.05})
      for (std::uint64_t i = 0; i < 5; ++i)
        realized(random_route(map, 12, random), workspace, {.iterations = 1'000, .seed = i, .robot = Disc{radius}});
  }
}

TEST(Realize, AStraightLegWithoutFurnitureIsAStraightLine) {
  const Map map = hallway(4);
  const Workspace workspace(map);
  const Motion motion = realized(route("0,0,90 F F F", map), workspace, {});
  EXPECT_EQ(motion, (Motion{{{0, 0, 90}, {3, 0, 90}}, Disc{0.05}}));
}

TEST(Realize, TurnsAreInPlace) {
  const Map map = hallway(4);
  const Workspace workspace(map);
  const Motion motion = realized(route("0,0,0 R F L L F", map), workspace, {});
  EXPECT_EQ(motion, (Motion{{{0, 0, 0}, {0, 0, 90}, {1, 0, 90}, {1, 0, 0}, {1, 0, 270}, {0, 0, 270}}, Disc{0.05}}));
}

TEST(Realize, DrivesRoundFurnitureAlmostAsShortAsCanBe) {
  const Map map = past_a_sofa();
  const Workspace workspace(map);
  const Motion motion = realized(route("0,0,90 F F", map), workspace, {.seed = 4});
  // The taut string from (0,0) to (2,0) round the disc of radius ρ at (1,0): two tangents and an arc.
  const double rho = workspace.furniture() + 0.05;
  const double taut = 2 * std::sqrt(1 - rho * rho) + 2 * rho * std::asin(rho);
  EXPECT_GE(length(motion), taut);
  EXPECT_LE(length(motion), 1.02 * taut) << show_line(motion);
}

TEST(Realize, TheSameSeedGivesTheSameBytesAndAnotherSeedAnotherPath) {
  const Map map = past_a_sofa();
  const Workspace workspace(map);
  const Trajectory there = route("0,0,90 F F", map);
  const Motion first = realized(there, workspace, {.iterations = 300, .seed = 5});
  const Motion other = realized(there, workspace, {.iterations = 300, .seed = 6});
  const Motion again = realized(there, workspace, {.iterations = 300, .seed = 5});
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
}

TEST(Realize, SaysWhichLegItDidNotFind) {
  const Map map = past_a_sofa();
  const Workspace blocked(map, {.width = 0.4, .furniture = 0.15});  // 0.05 on either side
  const auto outcome = realize(route("0,0,90 F F", map), blocked, {.iterations = 200, .robot = Disc{0.05}});
  ASSERT_TRUE(std::holds_alternative<Unreached>(outcome));
  const auto& unreached = std::get<Unreached>(outcome);
  EXPECT_EQ(map.pose(unreached.from), (Pose{0, 0, 90}));
  EXPECT_EQ(map.pose(unreached.to), (Pose{2, 0, 90}));
  EXPECT_EQ(unreached.iterations, 200U);
  EXPECT_NO_THROW(realized(route("0,0,90 F F", map), blocked, {.iterations = 2'000, .robot = Disc{0.01}}));
}

TEST(Realize, RefusesARobotThatFitsNowhere) {
  const Map map = past_a_sofa();
  const Workspace workspace(map);
  const Trajectory stay = route("0,0,90", map);
  for (double radius : {0.2, 1.0, -0.1, std::nan("")})
    EXPECT_THROW(realize(stay, workspace, {.robot = Disc{radius}}), std::invalid_argument) << radius;
  EXPECT_THROW(realize(route("1,0,90", map), workspace, {.robot = Disc{0.19}}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
