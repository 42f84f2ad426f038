#include "libplan/motion/terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libplan/motion/cells.hpp"
#include "libplan/motion/read_terrain.hpp"
#include "tests/libplan/motion/terrains.hpp"

namespace waymark::plan {
namespace {

TEST(Terrain, RefusesPolygonsThatAreNone) {
  const Polygon square = rectangle(0, 0, 4, 4);
  const struct {
    Polygon polygon;
    const char* fault;
  } table[] = {{{{0, 0}, {1, 0}}, "three corners"},
               {{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, "meets itself"},
               {{{0, 0}, {2, 0}, {1, 0}}, "meets itself"},
               {{{0, 0}, {0, 0}, {1, 1}}, "meets itself"}};
  for (const auto& row : table) {
    const auto expect_fault = [&](const std::string& where, const auto& make) {
      try {
        make();
        ADD_FAILURE() << where << " was taken";
      } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(row.fault), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find(where), 0U) << error.what();
      }
    };
    expect_fault("boundary", [&] { Terrain("t", row.polygon, {}, {}); });
    expect_fault("obstacles[1]", [&] { Terrain("t", square, {rectangle(1, 1, 2, 2), row.polygon}, {}); });
    expect_fault("regions[0].polygon", [&] { Terrain("t", square, {}, {{"a", row.polygon}}); });
  }
}

TEST(Terrain, ReadsTheRegionsThatContainAPoint) {
  const Terrain terrain = two_rooms();
  const auto names = [&](Point p) { return ltl::show(terrain.label(p), terrain.vocabulary()); };
  EXPECT_EQ(names({1, 1}), "{left}");
  EXPECT_EQ(names({2, 3.5}), "{left, wet}");
  EXPECT_EQ(names({5, 3.5}), "{wet}");
  EXPECT_EQ(names({8, 1}), "{right}");
  EXPECT_EQ(names({4, 1}), "{}");
}

TEST(TerrainCells, CutTheFreeSpaceIntoCellsOfOneLetter) {
  std::mt19937_64 random(4);
  for (const Terrain& terrain : {two_rooms(), diamonds()}) {
    const TerrainCells cells(terrain);
    double area = 0;
    for (const TerrainCell& cell : cells.cells()) area += cell.area;
    std::uniform_real_distribution<double> x(terrain.low().x, terrain.high().x), y(terrain.low().y, terrain.high().y);
    std::size_t free = 0;
    constexpr std::size_t samples = 20'000;
    for (std::size_t i = 0; i < samples; ++i) {
      const Point p{x(random), y(random)};
      const auto cell = cells.at(p);
      ASSERT_EQ(cell.has_value(), terrain.contains(p)) << p.x << ", " << p.y;
      if (!cell) continue;
      ++free;
      EXPECT_EQ(cells.letter_of(*cell), terrain.label(p)) << p.x << ", " << p.y;
    }
    const double whole = (terrain.high().x - terrain.low().x) * (terrain.high().y - terrain.low().y);
    EXPECT_NEAR(area / whole, static_cast<double>(free) / samples, 0.02) << terrain.name();
  }
}

TEST(TerrainCells, PassagesAreTheCommonBordersOfTwoFreeCells) {
  for (const Terrain& terrain : {two_rooms(), diamonds()}) {
    const TerrainCells cells(terrain);
    for (std::uint32_t i = 0; i < cells.cells().size(); ++i)
      for (const Passage& passage : cells.cells()[i].passages) {
        const Point middle{(passage.a.x + passage.b.x) / 2, (passage.a.y + passage.b.y) / 2};
        const Point there = cells.cells()[passage.to].centre, here = cells.cells()[i].centre;
        EXPECT_TRUE(terrain.admits(here, middle, 0)) << terrain.name() << " " << i << " " << passage.to;
        EXPECT_TRUE(terrain.admits(middle, there, 0)) << terrain.name() << " " << i << " " << passage.to;
        const auto& back = cells.cells()[passage.to].passages;
        EXPECT_TRUE(std::any_of(back.begin(), back.end(), [&](const Passage& p) { return p.to == i; }));
      }
  }
}

// Random straight lines: the cells that they pass one after the other are joined by passages.
TEST(TerrainCells, WhereOneCanGoAPassageLeads) {
  std::mt19937_64 random(5);
  for (const Terrain& terrain : {two_rooms(), diamonds()}) {
    const TerrainCells cells(terrain);
    std::uniform_real_distribution<double> x(terrain.low().x, terrain.high().x), y(terrain.low().y, terrain.high().y);
    std::size_t crossings = 0;
    for (int i = 0; i < 300; ++i) {
      const Point a{x(random), y(random)}, b{x(random), y(random)};
      if (!terrain.admits(a, b, 0)) continue;
      std::uint32_t last = cells.at(a).value();
      for (int k = 1; k <= 20'000; ++k) {
        const double t = k / 20'000.0;
        const auto now = cells.at({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}).value();
        if (now == last) continue;
        const auto& passages = cells.cells()[last].passages;
        EXPECT_TRUE(std::any_of(passages.begin(), passages.end(), [&](const Passage& p) { return p.to == now; }))
            << terrain.name() << " from {" << a.x << ", " << a.y << "} to {" << b.x << ", " << b.y << "}";
        last = now;
        ++crossings;
      }
    }
    EXPECT_GT(crossings, 100U);
  }
}

TEST(ReadTerrain, NamesWhatIsWrongAndWhere) {
  const struct {
    const char* text;
    const char* message;
    std::size_t line, column;
  } table[] = {
      {"{", "malformed JSON", 1, 2},
      {"[]", "expected an object with the key \"boundary\"", 1, 1},
      {"{\"boundary\":[[0,0],[1,0],[1,1]]}", "expected an object with the key \"regions\"", 1, 1},
      {"{\"boundary\":[[0,0],[1,0],\n[1]],\"regions\":[]}", "boundary[2]: expected a point [x,y]", 2, 1},
      {"{\"boundary\":[[0,0],[1,0]],\"regions\":[]}", "boundary: a polygon has at least three corners", 1, 13},
      {"{\"boundary\":[[0,0],[1,0],[1,1]],\"regions\":[{\"name\":\"a\",\n\"polygon\":[[0,0],[1,1],[1,0],[0,1]"
       "]}]}",
       "regions[0].polygon: the polygon meets itself", 2, 11},
      {"{\"boundary\":[[0,0],[1,0],[1,1]],\"regions\":[{\"name\":3}]}", "regions[0].name: expected a name", 1, 52},
  };
  for (const auto& row : table) try {
      parse_terrain(row.text, "t.json");
      ADD_FAILURE() << row.text << " was read";
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what();
      EXPECT_EQ(error.line(), row.line) << row.text;
      EXPECT_EQ(error.column(), row.column) << row.text;
    }
}

}  // namespace
}  // namespace waymark::plan
