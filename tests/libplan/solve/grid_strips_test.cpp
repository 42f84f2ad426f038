// Where blocks of grids are cut, and where their values stand then.
#include "libplan/solve/grid_strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace waymark::plan {
namespace {

GridWorld open_grid(std::uint32_t width, std::uint32_t height) {
  const ltl::Vocabulary none;
  return GridWorld({.width = width, .height = height, .motion = {SlipChances{}, {}, {}, {}}}, none, {{}},
                   std::vector<std::uint16_t>(std::size_t{width} * height, 0), 0);
}

// Some cells of a grid, by their distance from one of them.
GridStrips::Order outwards_from(std::uint32_t first, std::uint32_t width, std::uint32_t height, double share,
                                std::mt19937& random) {
  GridStrips::Order order;
  for (std::uint32_t cell = 0; cell < width * height; ++cell)
    if (std::uniform_real_distribution<>(0, 1)(random) < share) order.push_back({cell, 0});
  const auto distance = [&](const ProductState& s) {
    const auto apart = [](std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; };
    return apart(s.place % width, first % width) + apart(s.place / width, first / width);
  };
  std::stable_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return order;
}

TEST(GridCut, SmallBlocksAreNotCut) {
  EXPECT_EQ(GridCut::strips_for(1, 100), 1U);
  EXPECT_EQ(GridCut::strips_for(3'999, 100), 1U);
  EXPECT_EQ(GridCut::strips_for(4'000, 100), 2U);
  EXPECT_EQ(GridCut::strips_for(95'999, 100), 2U);
  EXPECT_EQ(GridCut::strips_for(96'000, 100), 3U);
  EXPECT_EQ(GridCut::strips_for(1'000'000'000, 100), 8U);
  EXPECT_EQ(GridCut::strips_for(1'000'000'000, 99), 1U);
}

// From one end of a long grid layers are lines across it: cuts along the grid give two threads work in each of them.
TEST(GridCut, IsAlongTheWay) {
  std::mt19937 random(3);
  const GridWorld wide = open_grid(200, 40), high = open_grid(40, 200);
  EXPECT_FALSE(GridCut::of(wide, outwards_from(0, 200, 40, 1, random), 160).by_columns);
  EXPECT_TRUE(GridCut::of(high, outwards_from(0, 40, 200, 1, random), 160).by_columns);
}

// Strips have about equal shares, and every line one strip, ascending.
TEST(GridCut, SharesAreEqual) {
  std::mt19937 random(4);
  for (const double share : {1.0, 0.6}) {
    const GridWorld grid = open_grid(500, 400);
    const auto order = outwards_from(77'777, 500, 400, share, random);
    const GridCut cut = GridCut::of(grid, order, 1'000);
    EXPECT_EQ(cut.strips, GridCut::strips_for(order.size(), 1'000));
    EXPECT_TRUE(std::is_sorted(cut.strip_of.begin(), cut.strip_of.end()));
    std::vector<std::size_t> cells(cut.strips, 0);
    for (const ProductState& s : order) ++cells[cut.strip(s.place)];
    for (const std::size_t own : cells) {
      EXPECT_GT(own * cut.strips, order.size() * 9 / 10);
      EXPECT_LT(own * cut.strips, order.size() * 11 / 10);
    }
  }
}

struct Swept {
  GridWorld grid;
  GridStrips::Order order;
  GridStrips strips;
};
Swept swept(std::uint32_t width, std::uint32_t height, double share, std::size_t chunk, std::mt19937& random) {
  GridWorld grid = open_grid(width, height);
  auto order = outwards_from(static_cast<std::uint32_t>(random() % (width * height)), width, height, share, random);
  GridStrips strips(grid, order, chunk);
  return {std::move(grid), std::move(order), std::move(strips)};
}

TEST(GridStrips, EveryCellHasASlotOfItsOwnAndFindsItsNeighboursByTheSameSteps) {
  std::mt19937 random(5);
  std::set<std::size_t> counts;
  int by_columns = 0;
  for (int round = 0; round < 12; ++round) {
    const auto width = static_cast<std::uint32_t>(20 + random() % 300), height = 12'000 / width + 1;
    const Swept one = swept(width, height, round % 3 == 0 ? 1 : 0.7, 100 + random() % 200, random);
    const GridStrips& strips = one.strips;
    counts.insert(strips.count());
    by_columns += strips.steps()[1] != 1 ? 1 : 0;
    std::map<std::uint32_t, std::uint32_t> cell_at;
    std::set<std::uint32_t> copies;
    GridStrips own = strips;
    own.exchange().for_each([&](std::uint32_t from, std::uint32_t to) {
      EXPECT_LT(to, strips.slots());
      EXPECT_TRUE(copies.insert(to).second);
      cell_at[to] = from;  // a slot; below, the cell that stands there
    });
    strips.for_each([&](std::uint32_t cell, std::uint32_t slot) {
      ASSERT_LT(slot, strips.slots());
      ASSERT_EQ(strips.slot(cell), slot);
      ASSERT_TRUE(cell_at.emplace(slot, cell).second);
    });
    ASSERT_EQ(cell_at.size(), one.order.size() + copies.size());
    for (const std::uint32_t copy : copies) cell_at[copy] = cell_at.at(cell_at[copy]);
    std::set<std::uint32_t> cells;
    for (const ProductState& s : one.order) cells.insert(s.place);
    for (const std::uint32_t cell : cells)
      for (std::uint32_t d = 0; d < 4; ++d) {
        const std::uint32_t to = one.grid.move(cell, d), slot = strips.slot(cell);
        if (to == cell || !cells.contains(to)) continue;
        const std::uint32_t beside = slot + static_cast<std::uint32_t>(strips.steps()[d]);
        ASSERT_TRUE(cell_at.contains(beside)) << "round " << round << ", cell " << cell << ", direction " << d;
        ASSERT_EQ(cell_at[beside], to) << "round " << round << ", cell " << cell << ", direction " << d;
        const std::uint32_t original = copies.contains(beside) ? strips.original(slot, beside) : beside;
        ASSERT_EQ(original, strips.slot(to)) << "round " << round << ", cell " << cell << ", direction " << d;
      }
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{2}));
  EXPECT_GT(by_columns, 0);
  EXPECT_LT(by_columns, 12);
}

// A chunk holds the cells of its place in the order, strip by strip, each in order.
TEST(GridStrips, ChunksAreThoseOfTheOrder) {
  std::mt19937 random(6);
  const std::size_t chunk = 150;
  const auto [grid, order, strips] = swept(130, 90, 0.8, chunk, random);
  EXPECT_EQ(strips.cells(), order.size());
  EXPECT_EQ(strips.chunks(), (order.size() + chunk - 1) / chunk);
  for (std::size_t c = 0; c < strips.chunks(); ++c) {
    std::vector<std::vector<std::uint32_t>> expected(strips.count());
    const GridCut cut = GridCut::of(grid, order, chunk);
    for (std::size_t i = c * chunk; i < std::min(order.size(), (c + 1) * chunk); ++i)
      expected[cut.strip(order[i].place)].push_back(strips.slot(order[i].place));
    for (std::size_t s = 0; s < strips.count(); ++s) {
      const auto found = strips.chunk(s, c);
      ASSERT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()), expected[s]) << "chunk " << c;
    }
  }
}

}  // namespace
}  // namespace waymark::plan
