#include "libplan/motion/clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "libltl/text/parse.hpp"
#include "tests/libplan/motion/terrains.hpp"

namespace waymark::plan {
namespace {

// Corners at random distances around a middle, by angle: simple, and seldom convex.
Polygon star(std::mt19937& random, Point middle, std::size_t corners) {
  std::uniform_real_distribution<double> length(0.3, 1.5), shift(-0.3, 0.3);
  Polygon out;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (static_cast<double>(i) + shift(random)) / static_cast<double>(corners);
    const double r = length(random);
    out.push_back({middle.x + r * std::cos(angle), middle.y + r * std::sin(angle)});
  }
  return out;
}

double distance_to(const Polygon& polygon, Point p) {
  if (contains(polygon, p)) return 0;
  double least = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, distance(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

// Every point within the distance is in the widened region; no point is beyond what mitred corners may add.
TEST(Clearance, WidenedRegionsContainWhatIsWithinReach) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 8), reaches(0.02, 0.6);
  std::size_t near = 0, far = 0;
  for (int round = 0; round < 200; ++round) {
    const Polygon avoided = star(random, {4, 4}, 3 + static_cast<std::size_t>(round) % 8);
    const double reach = reaches(random);
    const Terrain terrain("t", rectangle(0, 0, 8, 8), {}, {{"wet", avoided}, {"goal", rectangle(0, 0, 1, 1)}});
    const Terrain wide = widened(terrain, {"wet"}, reach);
    const ltl::Proposition wet = *wide.vocabulary().find("wet");
    for (int i = 0; i < 200; ++i) {
      const Point p{coordinate(random), coordinate(random)};
      const double away = distance_to(avoided, p);
      if (away <= reach) {
        ++near;
        ASSERT_TRUE(wide.label(p).contains(wet)) << "round " << round << " at " << p.x << ' ' << p.y;
      } else if (away > 6 * reach + 0.5) {
        ++far;
        ASSERT_FALSE(wide.label(p).contains(wet)) << "round " << round << " at " << p.x << ' ' << p.y;
      }
    }
    EXPECT_EQ(wide.regions()[1].border, terrain.regions()[1].border);
  }
  EXPECT_GT(near, 2'000U);
  EXPECT_GT(far, 2'000U);
}

TEST(Clearance, TellsAvoidedFromWanted) {
  const auto names = [](const char* text) {
    ltl::Arena arena;
    std::string out;
    for (const ltl::Proposition p : avoided(ltl::parse(text, arena))) out += arena.vocabulary().name(p) + ' ';
    return out;
  };
  EXPECT_EQ(names("F goal & G !wet"), "wet ");
  EXPECT_EQ(names("!wet U (goal & G !(ice | mud))"), "wet ice mud ");
  EXPECT_EQ(names("F a & F b"), "");
  EXPECT_EQ(names("!(F wet)"), "wet ");
  EXPECT_THROW(names("F(a & X F !a)"), std::invalid_argument);
  EXPECT_THROW(names("a <-> b"), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
