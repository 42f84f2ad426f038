#include "libplan/motion/steer_car.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/libplan/motion/routes.hpp"

namespace waymark::plan {
namespace {

// What no car does, seen by stepping along the motion and not by the arithmetic of pieces: turning by more than the
// way over the turning radius, or moving across its heading.
void expect_driven(const Motion& motion, double turning_radius) {
  constexpr int steps = 50;
  for (const Piece& piece : pieces_of(motion))
    for (int k = 0; k < steps; ++k) {
      const Configuration a = piece.at(1.0 * k / steps), b = piece.at((k + 1.0) / steps);
      const double way = distance(position(a), position(b));
      const double turn = std::abs(radians(turn_between(a.heading, b.heading)));
      EXPECT_LE(turn, way / turning_radius * (1 + 1e-3) + 1e-6) << show_line(motion);
      const Point middle = ahead_of(a.heading + turn_between(a.heading, b.heading) / 2);
      EXPECT_NEAR((b.x - a.x) * middle.y - (b.y - a.y) * middle.x, 0, 1e-7) << show_line(motion);
    }
}

Motion driven(const Trajectory& there, const Workspace& workspace, const Sampling& sampling) {
  const auto outcome = steer_car(there, workspace, sampling);
  const std::string label = workspace.map().name() + " " + show(there, workspace.map());
  if (const auto* unreached = std::get_if<Unreached>(&outcome))
    throw std::runtime_error("unreached: " + label + " to " + show(workspace.map().pose(unreached->to)));
  const Motion& motion = std::get<Motion>(outcome);
  expect_read_back(motion, there, workspace, label);
  expect_driven(motion, std::get<Car>(sampling.robot).turning_radius);
  return motion;
}

TEST(Drive, AStraightHallwayIsOneStraightLine) {
  const Map map = hallway(4);
  const Workspace workspace(map, {.furniture = 0});
  const Motion motion = driven(route("0,0,90 F F F", map), workspace, {.robot = Car{}});
  EXPECT_EQ(motion, (Motion{{{0, 0, 90}, {3, 0, 90}}, Car{}}));
}

TEST(Drive, CutsACornerAtLeastAsShortAsAQuarterOfACircle) {
  const Map map = square();
  const Workspace workspace(map, {.furniture = 0});
  const Motion motion = driven(route("0,0,90 F R F", map), workspace, {.robot = Car{}});
  EXPECT_LE(length(motion), 2 - 2 * 0.1 + radians(90) * 0.1) << show_line(motion);
  const auto pieces = pieces_of(motion);
  EXPECT_TRUE(std::all_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.way() > 0; }));
}

TEST(Drive, TurnsRoundInADeadEndByBackingUp) {
  const Map map = hallway(2);
  const Workspace workspace(map, {.furniture = 0});
  for (const char* turns : {"L L", "R R"}) {
    const Motion motion =
        driven(route(std::string("1,0,90 F ") + turns + " F", map), workspace, {.robot = Car{.turning_radius = 0.2}});
    const auto pieces = pieces_of(motion);
    EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.way() < 0; }))
        << show_line(motion);
  }
}

TEST(Drive, PassesAndRoundsFurniture) {
  for (const Map& map : {past_a_sofa(), square(), plus()}) {
    const Workspace workspace(map);
    const char* text = map.name() == "square" ? "1,0,180 F R F" : map.name() == "plus" ? "1,0,180 F L F" : "0,0,90 F F";
    driven(route(text, map), workspace, {.iterations = 300, .robot = Car{}});
  }
}

TEST(Drive, TheSameSeedGivesTheSameBytes) {
  const Map map = plus();
  const Workspace workspace(map);
  const Trajectory there = route("1,0,180 F L F L L F", map);
  const Sampling sampling{.iterations = 300, .seed = 5, .robot = Car{}};
  EXPECT_EQ(driven(there, workspace, sampling), driven(there, workspace, sampling));
}

TEST(Drive, SamplesWithEveryHeading) {
  const Car car{.turning_radius = 0.1};
  for (const int heading : {0, 90, 180, 270}) {
    const DriveProblem problem{.low = {-1, -1},
                               .high = {1, 1},
                               .turning_radius = car.turning_radius,
                               .is_free = [](const Line&) { return true; },
                               .start = {0, 0, 1.0 * heading},
                               .goals = {{0.5, 0.5, 1.0 * heading}}};
    for (const Sampler sampler : {Sampler::InformedRrtStar, Sampler::BitStar})
      EXPECT_GE(sample_drive(problem, {.sampler = sampler, .iterations = 50}).size(), 2U) << heading;
  }
}

TEST(Drive, RefusesACarThatFitsNowhere) {
  const Map map = past_a_sofa();
  const Workspace workspace(map);
  for (const Car& car : {Car{.width = 0.4}, Car{.length = 0}, Car{.turning_radius = -1}, Car{.length = std::nan("")}})
    EXPECT_THROW(steer_car(route("0,0,90", map), workspace, {.robot = car}), std::invalid_argument) << car.width;
  EXPECT_THROW(steer_car(route("1,0,90", map), workspace, {.robot = Car{.length = 1, .width = 0.3}}),
               std::invalid_argument);
}

TEST(Drive, SaysWhichLegItDidNotFind) {
  const Map map = past_a_sofa();
  const Workspace blocked(map, {.width = 0.4, .furniture = 0.15});
  const auto outcome = steer_car(route("0,0,90 F F", map), blocked, {.iterations = 50, .robot = Car{}});
  ASSERT_TRUE(std::holds_alternative<Unreached>(outcome));
  EXPECT_EQ(map.pose(std::get<Unreached>(outcome).to), (Pose{1, 0, 90}));
}

TEST(Drive, RandomRoutesOfTheShippedMaps) {
  std::mt19937_64 random(3);
  for (const char* name : {"grid", "jelly", "l"}) {
    const Map map = shipped(name);
    const Workspace workspace(map);
    for (std::uint64_t i = 0; i < 5; ++i)
      driven(random_route(map, 12, random), workspace, {.iterations = 300, .seed = i, .robot = Car{}});
  }
}

}  // namespace
}  // namespace waymark::plan
