#include "libplan/motion/workspace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

constexpr double pi = 3.14159265358979323846;

std::string show(Point p) { return "{" + std::to_string(p.x) + ", " + std::to_string(p.y) + "}"; }

// Free by definition: in a cell, and outside the furniture that stands in it.
bool is_free(const Workspace& workspace, Point p) {
  const auto cell = workspace.cell_at(p);
  if (!cell) return false;
  if (cell->kind == Cell::Kind::Edge) return true;
  const bool furnished = workspace.map().nodes()[cell->index].object.has_value();
  return !furnished || distance(p, workspace.centre(cell->index)) > workspace.furniture();
}

bool is_free_disc(const Workspace& workspace, Point p, double radius) {  // on 256 rays, 16 rings
  for (int ring = 0; ring <= 16; ++ring)
    for (int ray = 0; ray < 256; ++ray) {
      const double r = radius * ring / 16, angle = 2 * pi * ray / 256;
      if (!is_free(workspace, {p.x + r * std::cos(angle), p.y + r * std::sin(angle)})) return false;
    }
  return true;
}

TEST(Distance, OfPointsAndSegments) {
  EXPECT_DOUBLE_EQ(distance({0, 0}, {3, 4}), 5);
  EXPECT_DOUBLE_EQ(distance({1, 1}, {0, 0}, {2, 0}), 1);          // beside
  EXPECT_DOUBLE_EQ(distance({5, 4}, {0, 0}, {2, 0}), 5);          // beyond the end
  EXPECT_DOUBLE_EQ(distance({5, 4}, {2, 0}, {2, 0}), 5);          // a segment that is a point
  EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 2}, {0, 2}, {2, 0}), 0);  // crossing
  EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 0}, {1, 0}, {1, 5}), 0);  // touching
  EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 0}, {0, 3}, {2, 3}), 3);  // parallel
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {4, 4}, {9, 9}), 5);
}

TEST(Workspace, RefusesShapesThatAreNoHallways) {
  const Map map = plus();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const WorkspaceShape& shape : {WorkspaceShape{0, 0}, {1, 0}, {-0.4, 0}, {0.4, 0.2}, {0.4, -0.1}, {nan, 0}})
    EXPECT_THROW(Workspace(map, shape), std::invalid_argument) << shape.width << " " << shape.furniture;
  EXPECT_NO_THROW(Workspace(map, {0.9, 0.4}));
}

TEST(Workspace, CellsAreSquaresAndTheRectanglesBetweenThem) {
  const Map map = plus();  // the centre is node 0 at (1,1), the northern arm edge 0
  const Workspace workspace(map, {.width = 0.4, .furniture = 0.07});
  using enum Cell::Kind;
  const struct {
    Point p;
    std::optional<Cell> cell;
  } table[] = {
      {{1, 1}, Cell{Node, 0}},     {{1.19, 0.81}, Cell{Node, 0}}, {{1.1, 0.79}, Cell{Edge, 0}},
      {{1, 0.5}, Cell{Edge, 0}},   {{1, 0.21}, Cell{Edge, 0}},    {{1, 0.19}, Cell{Node, 1}},
      {{1, -0.19}, Cell{Node, 1}}, {{1, -0.21}, std::nullopt},    {{0.5, 1.1}, Cell{Edge, 3}},
      {{0.5, 1.21}, std::nullopt}, {{1.21, 0.79}, std::nullopt},  {{1, 1.5}, Cell{Edge, 2}},
      {{2, 1}, Cell{Node, 2}},     {{2.21, 1}, std::nullopt},     {{0, 0}, std::nullopt},
      {{1e300, 1}, std::nullopt},  {{1, -1e300}, std::nullopt},
  };
  for (const auto& row : table) EXPECT_EQ(workspace.cell_at(row.p), row.cell) << show(row.p);
}

TEST(Workspace, NeighboursWithoutHallwayAreWalledOff) {
  const std::vector<Node> nodes{{0, 0, {}, {}}, {1, 0, {}, {}}, {0, 1, {}, {}}, {1, 1, {}, {}}};
  const Map map("two hallways", nodes, {{0, 1, "", ""}, {2, 3, "", ""}}, {}, {}, {});
  const Workspace workspace(map, {.width = 0.9, .furniture = 0});
  EXPECT_TRUE(workspace.admits({0, 0.3}, {1, 0.3}, 0.1));
  EXPECT_FALSE(workspace.admits({0, 0.3}, {0, 0.7}, 0));
  EXPECT_FALSE(workspace.admits({0, 0.3}, {1, 0.7}, 0));
}

TEST(Workspace, ADiscFitsWhereAllItsPointsAreFree) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-0.5, 2.5), radii(0.01, 0.5);
  int fitting = 0;
  for (const Map& map : {plus(), square(), hallway(2)})
    for (const WorkspaceShape& shape : {WorkspaceShape{0.4, 0.07}, {0.4, 0}, {0.7, 0.2}, {0.95, 0.05}}) {
      const Workspace workspace(map, shape);
      for (int i = 0; i < 1'000; ++i) {
        const Point p{coordinate(random), coordinate(random)};
        const double radius = radii(random) * shape.width;
        const auto label = [&] { return map.name() + " " + show(p) + " radius " + std::to_string(radius); };
        if (workspace.admits(p, radius)) {
          ++fitting;
          EXPECT_TRUE(is_free_disc(workspace, p, radius * (1 - 1e-9))) << label();
        } else if (radius < shape.width / 2) {
          EXPECT_FALSE(is_free_disc(workspace, p, radius * 1.01 + 1e-3)) << label();
        }
      }
    }
  EXPECT_GT(fitting, 400);
}

TEST(Workspace, AMotionIsFreeWhereAllItsPointsAre) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-0.5, 2.5);
  std::size_t free = 0;
  for (const Map& map : {plus(), square(), hallway(2)})
    for (double radius : {0.0, 0.05}) {
      const Workspace workspace(map, {.width = 0.6, .furniture = 0.1});
      for (int i = 0; i < 10'000; ++i) {
        const Point a{coordinate(random), coordinate(random)}, b{coordinate(random), coordinate(random)};
        bool expected = true;
        for (int k = 0; k <= 100 && expected; ++k)
          expected = workspace.admits({a.x + (b.x - a.x) * k / 100, a.y + (b.y - a.y) * k / 100}, radius);
        // Between two samples 1/100 apart a corner may cut in by a little: accept either answer there.
        const bool almost = workspace.admits(a, b, std::max(0.0, radius - 0.01));
        const bool admitted = workspace.admits(a, b, radius);
        if (admitted) ++free;
        EXPECT_TRUE(!admitted || expected) << map.name() << " " << show(a) << " " << show(b);
        EXPECT_TRUE(admitted || !expected || almost || radius == 0) << map.name() << " " << show(a) << " " << show(b);
        EXPECT_EQ(admitted, workspace.admits(b, a, radius)) << map.name() << " " << show(a) << " " << show(b);
      }
    }
  EXPECT_GT(free, 300U);
}

TEST(Workspace, StandsAreInTheCellAndFree) {
  for (const char* name : {"grid", "jelly", "l"}) {
    const Map map = shipped(name);
    const Workspace workspace(map);
    for (std::uint32_t node = 0; node < map.nodes().size(); ++node) {
      const auto stands = workspace.stands(node, 0.05);
      ASSERT_FALSE(stands.empty()) << name << " " << node;
      EXPECT_EQ(map.nodes()[node].object.has_value(), stands.front() != workspace.centre(node));
      for (Point p : stands) {
        EXPECT_TRUE(workspace.admits(p, 0.05)) << show(p);
        EXPECT_EQ(workspace.cell_at(p), (Cell{Cell::Kind::Node, node})) << show(p);
      }
    }
  }
}

}  // namespace
}  // namespace waymark::plan
