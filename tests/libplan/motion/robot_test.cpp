#include "libplan/motion/robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "libplan/motion/motion.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

TEST(Piece, DrivesArcsToWhichTheHeadingIsTangent) {
  // North from (0,0), a quarter of a circle of radius 2 to the right: to (2,−2), headed east; backwards the other way.
  const double quarter = radians(90) * 2;
  const Configuration end = Piece::driving({0, 0, 0}, quarter, 90).at(1);
  EXPECT_NEAR(end.x, 2, 1e-12);
  EXPECT_NEAR(end.y, -2, 1e-12);
  EXPECT_DOUBLE_EQ(end.heading, 90);
  const Configuration back = Piece::driving({2, -2, 90}, -quarter, -90).at(1);
  EXPECT_NEAR(back.x, 0, 1e-12);
  EXPECT_NEAR(back.y, 0, 1e-12);
  EXPECT_DOUBLE_EQ(back.heading, 0);
}

TEST(Piece, TheArcBetweenTwoConfigurationsIsFoundAgain) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> heading(0, 360), way(-2, 2), turn(-170, 170);
  for (int i = 0; i < 2'000; ++i) {
    const Configuration from{0.3, -0.7, heading(random)};
    const Piece arc = Piece::driving(from, way(random), turn(random));
    const auto again = Piece::driving(from, arc.at(1));
    ASSERT_TRUE(again.has_value());
    EXPECT_NEAR(again->way(), arc.way(), 1e-9);
    EXPECT_NEAR(again->turn(), arc.turn(), 1e-9);
  }
}

// Every change of side of a line, seen by stepping, is among the parameters that were solved for.
TEST(Piece, PassesALineWhereItChangesSides) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> heading(0, 360), way(-3, 3), turn(-179, 179), number(-1, 1);
  std::size_t passed = 0;
  for (int i = 0; i < 500; ++i) {
    const Configuration from{number(random), number(random), heading(random)};
    const Piece arc = Piece::driving(from, way(random), turn(random));
    const Piece glide = Piece::gliding(from, {number(random), number(random), heading(random)});
    const Point normal{number(random), number(random)};
    const double offset = number(random);
    for (const Piece& piece : {arc, glide}) {
      std::vector<double> at;
      piece.passes_line(normal, offset, at);
      const auto side = [&](double t) {
        const Configuration c = piece.at(t);
        return normal.x * c.x + normal.y * c.y > offset;
      };
      constexpr int steps = 500;
      for (int k = 0; k < steps; ++k) {
        const double low = 1.0 * k / steps, high = (k + 1.0) / steps;
        if (side(low) == side(high)) continue;
        ++passed;
        EXPECT_TRUE(std::any_of(at.begin(), at.end(), [&](double t) { return t > low - 1e-9 && t < high + 1e-9; }))
            << from.x << " " << from.y << " " << from.heading << " " << piece.way() << " " << piece.turn();
      }
    }
  }
  EXPECT_GT(passed, 200U);
}

TEST(PieceBetween, IsWhatTheRobotCanDo) {
  const Car car{.length = 0.14, .width = 0.08, .turning_radius = 0.1};
  const struct {
    const char* what;
    Configuration from, to;
    bool disc, car;
  } table[] = {
      {"straight on", {0, 0, 90}, {1, 0, 90}, true, true},
      {"backwards", {0, 0, 90}, {-1, 0, 90}, true, true},
      {"sideways", {0, 0, 90}, {0, 1, 90}, true, false},
      {"on the spot", {0, 0, 90}, {0, 0, 91}, true, false},
      {"standing", {0, 0, 90}, {0, 0, 90}, true, true},
      {"a quarter at the turning radius", {0, 0, 0}, {0.1, -0.1, 90}, true, true},
      {"a quarter, a little tighter", {0, 0, 0}, {0.0999, -0.0999, 90}, true, false},
      {"off the arc", {0, 0, 0}, {0.5, -0.4, 90}, true, false},
      {"half a turn", {0, 0, 0}, {0.5, 0, 180}, false, false},
  };
  for (const auto& row : table) {
    EXPECT_EQ(piece_between(row.from, row.to, Disc{}).has_value(), row.disc) << row.what;
    EXPECT_EQ(piece_between(row.from, row.to, car).has_value(), row.car) << row.what;
  }
}

TEST(Motion, ReadsTheRouteOfACar) {
  const Map map = square();
  const Workspace workspace(map, {.width = 0.4, .furniture = 0});
  const auto route_text = [&](const std::vector<Configuration>& line) {
    const auto read = route_of({line, Car{}}, workspace);
    if (const auto* fault = std::get_if<NoRoute>(&read)) return std::to_string(fault->step) + ": " + fault->reason;
    return show(std::get<Trajectory>(read), map);
  };
  EXPECT_EQ(route_text({{0, 0, 90}, {0.9, 0, 90}, {1, 0.1, 180}, {1, 1, 180}}), "0,0,90 FORWARD RIGHT FORWARD");
  EXPECT_EQ(route_text({{0, 0, 90}, {0.6, 0, 90}, {0.1, 0, 90}}), "0,0,90");  // into the hallway and back
  EXPECT_EQ(route_text({{1, 0, 90}, {0, 0, 90}}), "1: the robot enters a place that is not ahead of it");
  EXPECT_EQ(route_text({{0, 0, 90}, {0, 0, 180}}), "1: a car cannot drive there along one arc");
  EXPECT_EQ(route_text({{0, 0.16, 90}, {1, 0.16, 90}}), "1: the robot touches a wall or furniture");
  const Configuration hallway{0.6, 0, 90};
  EXPECT_EQ(route_text({{0, 0, 90}, hallway, Piece::driving(hallway, radians(50) * 0.1, 50).at(1)}),
            "2: the robot turns between two places");
}

TEST(Workspace, ACarIsFreeWhereItsBodyIs) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-0.3, 2.3), heading(0, 360);
  const Car car{.length = 0.2, .width = 0.1, .turning_radius = 0.1};
  std::size_t free = 0, touching = 0;
  for (const Map& map : {plus(), square()}) {
    const Workspace workspace(map);
    for (int i = 0; i < 20'000; ++i) {
      const Configuration c{coordinate(random), coordinate(random), heading(random)};
      const Box box = body(car, c);
      bool expected = true;  // points of the body, by the definition of free space
      for (int a = 0; a <= 20 && expected; ++a)
        for (int b = 0; b <= 10 && expected; ++b) {
          const double u = a / 20.0, v = b / 10.0;
          const Point p{box[0].x + v * (box[1].x - box[0].x) + u * (box[3].x - box[0].x),
                        box[0].y + v * (box[1].y - box[0].y) + u * (box[3].y - box[0].y)};
          const auto cell = workspace.cell_at(p);
          const bool furnished = cell && cell->kind == Cell::Kind::Node && map.nodes()[cell->index].object.has_value();
          expected = cell && (!furnished || distance(p, workspace.centre(cell->index)) > workspace.furniture());
        }
      const bool admitted = admits(workspace, c, car);
      if (admitted) {
        EXPECT_TRUE(expected) << c.x << ", " << c.y << ", " << c.heading;
        ++free;
      } else if (expected) {
        ++touching;  // a corner of a wall between two of the points
      }
    }
  }
  EXPECT_GT(free, 500U);
  EXPECT_LT(touching, free / 10);
}

// Along arcs: what is admitted is free at every configuration, and what is free with room to spare is admitted.
TEST(Workspace, AnArcIsFreeWhereAllItsConfigurationsAre) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> coordinate(-0.2, 1.2), heading(0, 360), way(-0.5, 0.5), turn(-100, 100);
  const Map map = square();
  const Workspace workspace(map);
  const Car car{.length = 0.14, .width = 0.08, .turning_radius = 0.1}, larger{.length = 0.16, .width = 0.1};
  std::size_t free = 0, tight = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Configuration from{coordinate(random), coordinate(random), heading(random)};
    const Piece piece = Piece::driving(from, way(random), turn(random));
    bool all = true, roomy = true;
    for (int k = 0; k <= 100 && all; ++k) {
      all = admits(workspace, piece.at(k / 100.0), car);
      roomy = roomy && admits(workspace, piece.at(k / 100.0), larger);
    }
    const bool admitted = admits(workspace, piece, car);
    if (admitted) {
      ++free;
      EXPECT_TRUE(all) << from.x << ", " << from.y << ", " << from.heading;
    } else if (all && roomy) {
      ++tight;
    }
  }
  EXPECT_GT(free, 300U);
  EXPECT_EQ(tight, 0U);
}

}  // namespace
}  // namespace waymark::plan
