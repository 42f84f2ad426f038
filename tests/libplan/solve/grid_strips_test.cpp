// Where blocks of grids are cut, and where their values stand then.
#include "libplan/solve/grid_strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>

#include "tests/support/sanitizers.hpp"

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
TEST(GridCut, OfNoStatesIsOneStrip) {
  const GridCut cut = GridCut::of(open_grid(5, 4), {}, 64);
  EXPECT_EQ(cut.strips, 1U);
  for (std::uint32_t cell = 0; cell < 20; ++cell) EXPECT_EQ(cut.strip(cell), 0U);
}

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

// Some of the cells, of some lines more than of others, in any order.
GridStrips::Order uneven(std::uint32_t width, std::uint32_t height, std::mt19937& random) {
  const auto weights = [&](std::uint32_t lines) {
    std::vector<double> out(lines);
    double weight = 0;
    for (double& own : out) {
      if (random() % 8 == 0) weight = static_cast<double>(random() % 4) / 3;
      own = weight;
    }
    out[random() % lines] = 1;
    return out;
  };
  const std::vector<double> of_column = weights(width), of_row = weights(height);
  GridStrips::Order order;
  for (std::uint32_t cell = 0; cell < width * height; ++cell)
    if (std::uniform_real_distribution<>(0, 1)(random) < std::max(of_column[cell % width], of_row[cell / width]))
      order.push_back({cell, 0});
  const auto kind = random() % 3;
  if (kind == 0) std::shuffle(order.begin(), order.end(), random);
  if (kind == 1)
    std::stable_sort(order.begin(), order.end(),
                     [&](const ProductState& a, const ProductState& b) { return a.place % width < b.place % width; });
  return order;
}

// A line belongs to the share in which its middle lies, that is half of its states, rounded down. Strips are the shares
// that lines belong to, but a new one does not begin before there are states in the one before it.
std::vector<std::uint32_t> strips_by_definition(const std::vector<std::size_t>& states_of_line, std::size_t shares) {
  std::size_t all = 0, before = 0, last = 0;
  for (const std::size_t states : states_of_line) all += states;
  std::vector<std::uint32_t> out;
  for (const std::size_t states : states_of_line) {
    std::size_t share = 0;
    while (share + 1 < shares && (share + 1) * all <= (before + states / 2) * shares) ++share;
    const std::uint32_t strip = out.empty() ? 0 : out.back();
    out.push_back(share > last && before > 0 ? strip + 1 : strip);
    last = share;
    before += states;
  }
  return out;
}

// What two threads that take every other strip wait for: chunk by chunk, the states of the busier one.
std::size_t busiest(const GridStrips::Order& order, std::size_t chunk, const auto& strip_of) {
  std::size_t sum = 0;
  for (std::size_t begin = 0; begin < order.size(); begin += chunk) {
    const std::size_t end = std::min(order.size(), begin + chunk);
    std::size_t odd = 0;
    for (std::size_t i = begin; i < end; ++i) odd += strip_of(order[i].place) % 2;
    sum += std::max(odd, end - begin - odd);
  }
  return sum;
}

TEST(GridCut, IsThatOfTheDefinition) {
  std::mt19937 random(7);
  std::map<std::size_t, int> by_count;
  int by_columns = 0, by_rows = 0;
  for (int round = 0; round < waymark::testing::scaled(150); ++round) {
    const auto width = static_cast<std::uint32_t>(8 + random() % 400);
    const std::uint32_t height = (round % 10 == 0 ? 300'000 : 9'000) / width + 1;
    const GridWorld grid = open_grid(width, height);
    auto order = uneven(width, height, random);
    order.resize(std::min<std::size_t>(order.size(), 131'000));  // of more some are looked at, not all
    const std::size_t chunk = 100 + random() % 300, shares = GridCut::strips_for(order.size(), chunk);
    std::vector<std::size_t> rows(height, 0), columns(width, 0);
    for (const ProductState& s : order) {
      ++rows[s.place / width];
      ++columns[s.place % width];
    }
    const auto row_strips = strips_by_definition(rows, shares), column_strips = strips_by_definition(columns, shares);
    const GridCut cut = GridCut::of(grid, order, chunk);
    const bool expected =
        shares > 1 && busiest(order, chunk, [&](std::uint32_t cell) { return column_strips[cell % width]; }) <
                          busiest(
                              order, chunk, [&](std::uint32_t cell) { return row_strips[cell / width]; });
    ASSERT_EQ(cut.by_columns, expected) << "round " << round;
    ASSERT_EQ(cut.strip_of, expected ? column_strips : row_strips) << "round " << round;
    ASSERT_EQ(cut.strips, cut.strip_of.back() + 1) << "round " << round;
    ++by_count[cut.strips];
    ++(expected ? by_columns : by_rows);
  }
  EXPECT_GE(by_count.size(), waymark::testing::sanitized ? 2U : 3U);
  EXPECT_GT(by_columns, waymark::testing::scaled(20));
  EXPECT_GT(by_rows, waymark::testing::scaled(20));
}

// From west to east in one row: by rows there is one strip, by columns two, and no layer has work for both.
TEST(GridCut, OfOneLineIsByRowsIntoOneStrip) {
  for (const std::uint32_t row : {0U, 1U}) {
    GridStrips::Order order;
    for (std::uint32_t x = 0; x < 5'000; ++x) order.push_back({row * 5'000 + x, 0});
    const GridCut cut = GridCut::of(open_grid(5'000, 3), order, 100);
    EXPECT_FALSE(cut.by_columns);
    EXPECT_EQ(cut.strips, 1U);
    EXPECT_EQ(cut.strip_of, (std::vector<std::uint32_t>{0, 0, 0}));
    if (row == 0) continue;
    order.insert(order.begin(), {0, 0});  // the row before has one state: a strip of its own
    EXPECT_EQ(GridCut::of(open_grid(5'000, 3), order, 100).strip_of, (std::vector<std::uint32_t>{0, 1, 1}));
  }
}

struct Swept {
  GridWorld grid;
  GridStrips::Order order;
  GridStrips strips;
};
Swept swept(std::uint32_t width, std::uint32_t height, double share, std::size_t chunk, std::mt19937& random) {
  GridWorld grid = open_grid(width, height);
  auto order =
      outwards_from(static_cast<std::uint32_t>(random() % (std::size_t{width} * height)), width, height, share, random);
  GridStrips strips(grid, order, chunk);
  return {std::move(grid), std::move(order), std::move(strips)};
}

void expect_slots(const Swept& one, const std::string& what) {
  const GridStrips& strips = one.strips;
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
  std::vector<bool> swept(one.grid.states(), false);
  for (const ProductState& s : one.order) swept[s.place] = true;
  for (const ProductState& s : one.order)
    for (std::uint32_t d = 0; d < 4; ++d) {
      const std::uint32_t to = one.grid.move(s.place, d), slot = strips.slot(s.place);
      if (to == s.place || !swept[to]) continue;
      const std::uint32_t beside = slot + static_cast<std::uint32_t>(strips.steps()[d]);
      const auto found = cell_at.find(beside);
      ASSERT_NE(found, cell_at.end()) << what << ", cell " << s.place << ", direction " << d;
      ASSERT_EQ(found->second, to) << what << ", cell " << s.place << ", direction " << d;
      const std::uint32_t original = copies.contains(beside) ? strips.original(slot, beside) : beside;
      ASSERT_EQ(original, strips.slot(to)) << what << ", cell " << s.place << ", direction " << d;
    }
}

TEST(GridStrips, EveryCellHasASlotOfItsOwnAndFindsItsNeighboursByTheSameSteps) {
  std::mt19937 random(5);
  std::set<std::size_t> counts;
  int by_columns = 0;
  for (int round = 0; round < 12; ++round) {
    const auto width = static_cast<std::uint32_t>(20 + random() % 300), height = 12'000 / width + 1;
    const Swept one = swept(width, height, round % 3 == 0 ? 1 : 0.7, 100 + random() % 200, random);
    counts.insert(one.strips.count());
    by_columns += one.strips.steps()[1] != 1 ? 1 : 0;
    expect_slots(one, "round " + std::to_string(round));
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{2}));
  EXPECT_GT(by_columns, 0);
  EXPECT_LT(by_columns, 12);
}

// Strips of one line each, which have copies of both their neighbours, and that these have copies of.
TEST(GridStrips, MayBeOfOneLine) {
  for (const bool wide : {false, true}) {
    const std::uint32_t length = 32'500, width = wide ? length : 3, height = wide ? 3 : length;
    GridWorld grid = open_grid(width, height);
    GridStrips::Order order;
    for (std::uint32_t along = 0; along < length; ++along)
      for (std::uint32_t line = 0; line < 3; ++line)
        order.push_back({wide ? line * width + along : along * 3 + line, 0});
    GridStrips strips(grid, order, 120);
    EXPECT_EQ(strips.count(), 3U);
    expect_slots({std::move(grid), std::move(order), std::move(strips)}, wide ? "wide" : "high");
  }
}

// Many strips have copies between them, all of which have room; the last line has some behind it, to be stepped into.
TEST(GridStrips, HaveRoomForTheirCopies) {
  std::mt19937 random(9);
  GridStrips strips = swept(520, 500, 1, 2'000, random).strips;
  EXPECT_EQ(strips.count(), 8U);
  std::uint32_t last = 0, copies = 0;
  strips.for_each_slot([&](std::uint32_t slot) { last = std::max(last, slot); });
  strips.exchange().for_each([&](std::uint32_t, std::uint32_t to) {
    ASSERT_LT(to, strips.slots());
    ++copies;
  });
  const std::int32_t line = *std::max_element(strips.steps().begin(), strips.steps().end());
  EXPECT_LT(last + static_cast<std::uint32_t>(line), strips.slots());
  EXPECT_GE(copies, 14U * 500U);
}

// After a pass over one chunk the copies of what is in that chunk are told, and no others.
TEST(GridStrips, CopiesAreToldWithTheirChunk) {
  std::mt19937 random(8);
  const std::size_t chunk = 150;
  auto [grid, order, strips] = swept(130, 90, 0.8, chunk, random);
  std::vector<std::size_t> chunk_of(strips.slots(), SIZE_MAX);
  for (std::size_t i = 0; i < order.size(); ++i) chunk_of[strips.slot(order[i].place)] = i / chunk;
  for (std::size_t c = 0; c < strips.chunks(); ++c) {
    std::vector<double> numbers(strips.slots(), 1);
    strips.exchange().copy(numbers);
    strips.for_each_slot([&](std::uint32_t slot) { numbers[slot] = 2; });
    const Pass pass{c, c + 1};
    for (std::size_t s = 0; s < strips.count(); ++s) strips.exchange().tell(s, {pass, {0, 0}, 0}, numbers);
    for (std::size_t s = 0; s < strips.count(); ++s) strips.exchange().take(s, {pass, pass, 1}, numbers);
    strips.exchange().for_each([&](std::uint32_t from, std::uint32_t to) {
      EXPECT_EQ(numbers[to], chunk_of[from] == c ? 2 : 1) << "chunk " << c;
    });
  }
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
