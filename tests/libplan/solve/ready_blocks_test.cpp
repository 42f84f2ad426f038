// Blocks of grids made ready, and their states in parts that are swept side by side.
#include "libplan/solve/ready_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/solve/ordered_parts.hpp"

namespace waymark::plan {
namespace {

using OfGrid = GridBlock::Product;

// An open grid with a in one corner and b in the other, on which moves may slip.
struct Corners {
  Corners(std::uint32_t width, std::uint32_t height, const char* formula)
      : names({"a", "b"}),
        arena(names),
        grid({.width = width, .height = height, .motion = {slips, slips, slips, slips}}, names,
             {{}, {.label = {ltl::Proposition{0}}}, {.label = {ltl::Proposition{1}}}}, cells(width, height), width / 2),
        task(automata::ltlf_to_dfa(ltl::parse(formula, arena)), grid.letters()),
        product(OfGrid::explore(grid, task).value()),
        unknowns{StateSet(product.states(), false), StateSet(product.states(), false), {}} {
    product.for_each_state(
        [&](const auto& s) { (product.is_goal(s) ? unknowns.targets : unknowns.unknown).insert(s.index); });
  }
  static std::vector<std::uint16_t> cells(std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint16_t> out(std::size_t{width} * height, 0);
    out.front() = 1;
    out.back() = 2;
    return out;
  }
  static constexpr SlipChances slips{.forward = 0.8, .left = 0.1, .right = 0.1};
  ltl::Vocabulary names;
  ltl::Arena arena;
  GridWorld grid;
  TaskTable task;
  OfGrid product;
  Unknowns unknowns;
};

bool same(const std::vector<OfGrid::Compact>& a, const std::vector<OfGrid::Compact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.place == other.place && one.task == other.task;
  });
}

// Every block once; on a grid are those of more unknowns than the limit, where their kind allows, unless policies are
// asked for. How many are.
template <class AnyProduct>
std::size_t expect_blocks(const AnyProduct& product, const Corners& corners, const IterationOptions& options,
                          const Strategy* only = nullptr) {
  const EndComponentQuotient<AnyProduct> merged(product, corners.unknowns);
  const ReadyBlocks<AnyProduct, Measure::MinCost> ready(product, corners.unknowns, merged, options);
  const auto& blocks = product.blocks();
  std::size_t on_grid = 0, seen = 0;
  while (seen + 1 < blocks.size())
    for (const auto& block : ready.some(seen)) {
      const auto expected = merged.in_order(blocks[seen], blocks[seen + 1]);
      const bool on = !options.policy_iteration && expected.states.size() > options.on_grid &&
                      GridBlock::of(corners.product, corners.unknowns, Measure::MinCost, expected, only).has_value();
      EXPECT_EQ(block.grid.has_value(), on) << "block " << seen;
      if (block.grid) {
        EXPECT_EQ(block.grid->cells(), expected.states.size());
      } else {
        EXPECT_TRUE(same(block.order.states, expected.states)) << "block " << seen;
        EXPECT_EQ(block.order.layers, expected.layers) << "block " << seen;
      }
      on_grid += on ? 1 : 0;
      ++seen;
    }
  EXPECT_EQ(seen + 1, blocks.size());
  for (std::size_t b = 0; b < seen; ++b) EXPECT_EQ(ready.some(b).size(), seen - b) << "from block " << b << " on";
  return on_grid;
}

TEST(ReadyBlocks, AreAllBlocksAndLargeOnesOnTheirGrid) {
  const Corners corners(9, 7, "F (a & F b)");
  Strategy east{Choices(corners.product.states()), corners.product.starts().front()};
  corners.product.for_each_state([&](const auto& s) {
    if (!corners.product.is_goal(s)) east.choice.set(s.index, s.index % 4);
  });
  const StrategyChain<OfGrid> chain(corners.product, east);
  for (const std::size_t threads : {1U, 3U}) {
    const auto options = [&](std::size_t on_grid, bool policies) {
      return IterationOptions{.policy_iteration = policies, .on_grid = on_grid, .sweepers = {.threads = threads}};
    };
    EXPECT_EQ(expect_blocks(corners.product, corners, options(0, false)), 2U);
    EXPECT_EQ(expect_blocks(corners.product, corners, options(61, false)), 2U);
    EXPECT_EQ(expect_blocks(corners.product, corners, options(62, false)), 0U) << "no more than the limit";
    EXPECT_EQ(expect_blocks(corners.product, corners, options(0, true)), 0U);
    EXPECT_EQ(expect_blocks(chain, corners, options(0, false), &east), 2U);
  }
  const Corners steps(9, 7, "X X F b");  // to stay at the start is to go on to the next step
  EXPECT_EQ(expect_blocks(steps.product, steps, {.on_grid = 0}), 1U);
  EXPECT_EQ(steps.product.blocks().size(), 5U);
}

TEST(GridBlock, IsOfOneTaskAndOfStatesThatAreNotMerged) {
  const Corners corners(9, 7, "F (a & F b)");
  const EndComponentQuotient<OfGrid> none(corners.product, corners.unknowns);
  const auto& blocks = corners.product.blocks();
  const auto of = [&](const Unknowns& unknowns, const GridBlock::Order& order) {
    return GridBlock::of(corners.product, unknowns, Measure::MaxProbability, order).has_value();
  };
  std::vector<GridBlock::Order> orders;
  for (std::size_t b = 0; b + 1 < blocks.size(); ++b) {
    const auto order = none.in_order(blocks[b], blocks[b + 1]);
    if (!order.states.empty()) orders.push_back(order);
  }
  ASSERT_EQ(orders.size(), 2U);
  GridBlock::Order both = orders[0];
  both.states.push_back(orders[1].states.back());
  EXPECT_TRUE(of(corners.unknowns, orders[0]) && of(corners.unknowns, orders[1]));
  EXPECT_FALSE(of(corners.unknowns, both));
  Unknowns merging = corners.unknowns;
  merging.merged = {std::vector<std::uint32_t>(corners.product.states(), EndComponents::none), 1};
  EXPECT_TRUE(of(merging, orders[0])) << "nothing of this block";
  merging.merged.of[corners.product.state(orders[0].states.back()).index] = 0;
  EXPECT_FALSE(of(merging, orders[0]));
  EXPECT_TRUE(of(merging, orders[1]));
}

// Part after part, each in the order, of one strip of the grid each; chunks are those of the order.
TEST(OrderedParts, OfGridsAreTheStripsOfItsCut) {
  const Corners corners(110, 60, "F (a & F b)");
  const EndComponentQuotient<OfGrid> merged(corners.product, corners.unknowns);
  SweepOrder<std::uint32_t> order;
  for (std::size_t b = 0; b + 1 < corners.product.blocks().size(); ++b) {
    const auto block = merged.in_order(corners.product.blocks()[b], corners.product.blocks()[b + 1]);
    for (const auto& c : block.states) order.states.push_back(corners.product.state(c).index);
    order.layers += block.layers;
  }
  ASSERT_EQ(order.states.size(), 2 * 6'600U - 2);
  std::vector<ProductState> places;
  for (const std::uint32_t i : order.states) places.push_back(corners.product.compact(corners.product.state(i)));
  const GridCut cut = GridCut::of(corners.grid, places, order.chunk_size());
  const OrderedParts parts = OrderedParts::of(corners.product, order);
  ASSERT_EQ(cut.strips, 2U);
  ASSERT_EQ(parts.count(), 2U);
  ASSERT_EQ(parts.begin.size(), 3U);
  EXPECT_EQ(parts.begin.back(), order.states.size());
  EXPECT_EQ(parts.chunks, (order.states.size() + order.chunk_size() - 1) / order.chunk_size());
  std::vector<std::uint32_t> next = parts.begin;
  for (std::size_t i = 0; i < order.states.size(); ++i) {
    const std::uint32_t part = cut.strip(places[i].place), at = next[part]++;
    ASSERT_EQ(parts.states[at], order.states[i]) << i;
    ASSERT_EQ(parts.part(at), part) << i;
    ASSERT_EQ(parts.chunk(part, at), i / order.chunk_size()) << i;
  }
  EXPECT_EQ(next[0], parts.begin[1]);
  EXPECT_EQ(next[1], parts.begin[2]);
}

}  // namespace
}  // namespace waymark::plan
