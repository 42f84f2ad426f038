// Blocks of grids that are swept in place: the values of linear solves, on small grids of every kind.
#include "libplan/solve/grid_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/solve/decide.hpp"
#include "libplan/solve/reachability.hpp"
#include "libplan/solve/value_iteration.hpp"
#include "tests/libplan/solve/random_grids.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

constexpr double tolerance = 1e-6;
constexpr double rounding = 1 + 1e-12;  // what bounds are sound up to

// Of how many blocks of the question "least cost to a goal" the kind is one that is swept in place.
std::size_t swept_in_place(const GridBlock::Product& product) {
  Unknowns unknowns{{}, StateSet(product.states(), false), {}};
  product.for_each_state([&](const auto& s) { unknowns.targets.set(s.index, product.is_goal(s)); });
  unknowns.unknown = almost_surely(product, unknowns.targets);
  for (std::uint32_t i = 0; i < product.states(); ++i)
    if (unknowns.targets[i]) unknowns.unknown.erase(i);
  std::size_t count = 0;
  const auto& blocks = product.blocks();
  for (std::size_t b = 0; b + 1 < blocks.size(); ++b) {
    const auto order = EndComponentQuotient<GridBlock::Product>(product, unknowns).in_order(blocks[b], blocks[b + 1]);
    if (order.states.empty()) continue;
    count += GridBlock::of(product, unknowns, Measure::MinCost, order).has_value() ? 1 : 0;
  }
  return count;
}

TEST(GridBlock, AgreesWithLinearSolves) {
  constexpr std::uint64_t seed = 72;
  ltl::Random random(seed);
  std::size_t in_place = 0, finite = 0, unsure = 0;
  for (int round = 0; round < 120; ++round) {
    const GridWorld grid = testing::noisy_grid(random);
    for (const char* text :
         {"F (a & F b)", "!x U (a & (!x U b))", "F a & F b", "X X F b", "F (x & X !x)", "F (a & X F a)"}) {
      ltl::Arena arena(grid.letters().vocabulary());
      const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(text, arena));
      const TaskTable task(dfa, grid.letters());
      const auto product = GridBlock::Product::explore(grid, task);
      ASSERT_TRUE(product);
      in_place += swept_in_place(*product);
      const IterationOptions sweeps{.tolerance = tolerance, .on_grid = 0};
      const IterationOptions solves{.tolerance = tolerance, .policy_iteration = true};
      const auto qualitative = greatest_probability(*product, sweeps),
                 chance_too = greatest_probability(*product, solves);
      ASSERT_TRUE(qualitative && chance_too) << text << "  round " << round << "  seed " << seed;
      EXPECT_NEAR(qualitative->value.middle(), chance_too->value.middle(), tolerance)
          << text << "  round " << round << "  seed " << seed;
      unsure += qualitative->value.middle() > tolerance && qualitative->value.middle() < 1 - tolerance ? 1 : 0;
      const auto cost = least_cost(*product, sweeps), cost_too = least_cost(*product, solves);
      ASSERT_TRUE(cost && cost_too) << text << "  round " << round << "  seed " << seed;
      EXPECT_EQ(std::isinf(cost->value.lower), std::isinf(cost_too->value.lower));
      if (std::isinf(cost->value.lower)) continue;
      ++finite;
      EXPECT_LE(cost->value.lower, cost_too->value.upper * rounding)
          << text << "  round " << round << "  seed " << seed;
      EXPECT_GE(cost->value.upper * rounding, cost_too->value.lower)
          << text << "  round " << round << "  seed " << seed;
      EXPECT_LE(cost->value.upper, cost->value.lower * (1 + 2 * tolerance));
    }
  }
  EXPECT_GT(in_place, 200U);
  EXPECT_GT(finite, 100U);
  EXPECT_GT(unsure, 20U);
}

// Grids on which sweeps move on in a window, of many layers of distance: what equations written out say.
TEST(GridBlock, AgreesWithEquationsWhereAWindowMovesOn) {
  std::size_t finite = 0, unsure = 0;
  for (const GridKind kind : all_grid_kinds)
    for (const double noise : {0.02, 0.1, 0.2}) {
      std::ostringstream text;
      write_case(text, generate_grid({.kind = kind,
                                      .width = ::waymark::testing::sanitized ? 24U : 48U,
                                      .height = ::waymark::testing::sanitized ? 20U : 40U,
                                      .landmarks = 2,
                                      .noise = noise,
                                      .seed = 9,
                                      .tasks = true}));
      const PlanningCase read = parse_case(text.str());
      const auto& grid = std::get<GridWorld>(read.model);
      for (const CaseTask& asked : read.tasks) {
        if (asked.id != "seq" && asked.id != "avoidseq") continue;
        const std::string what = read.name + " " + asked.id + "  noise " + std::to_string(noise);
        ltl::Arena arena(grid.letters().vocabulary());
        const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(asked.formula, arena));
        const TaskTable task(dfa, grid.letters());
        const auto product = GridBlock::Product::explore(grid, task);
        ASSERT_TRUE(product);
        const IterationOptions in_place{.tolerance = tolerance, .on_grid = 0};
        const IterationOptions written{.tolerance = tolerance, .on_grid = SIZE_MAX};
        const auto cost = least_cost(*product, in_place), cost_too = least_cost(*product, written);
        ASSERT_TRUE(cost && cost_too) << what;
        EXPECT_EQ(std::isinf(cost->value.lower), std::isinf(cost_too->value.lower)) << what;
        if (!std::isinf(cost->value.lower)) {
          ++finite;
          EXPECT_LE(cost->value.lower, cost_too->value.upper * rounding) << what;
          EXPECT_GE(cost->value.upper * rounding, cost_too->value.lower) << what;
          EXPECT_LE(cost->value.upper, cost->value.lower * (1 + 2 * tolerance)) << what;
        }
        const auto qualitative = greatest_probability(*product, in_place),
                   chance_too = greatest_probability(*product, written);
        ASSERT_TRUE(qualitative && chance_too) << what;
        EXPECT_LE(qualitative->value.lower, chance_too->value.upper * rounding) << what;
        EXPECT_GE(qualitative->value.upper * rounding, chance_too->value.lower) << what;
        unsure += qualitative->value.middle() > tolerance && qualitative->value.middle() < 1 - tolerance ? 1 : 0;
      }
    }
  EXPECT_GT(finite, 9U);
  EXPECT_GT(unsure, 3U);
}

// Costs of blocks that are cut into strips, of every state: those of equations written out.
TEST(GridBlock, OfSeveralStripsAgreesWithEquations) {
  for (const GridKind kind : {GridKind::Rooms, GridKind::Scatter}) {
    std::ostringstream text;
    write_case(text, generate_grid({.kind = kind, .width = 110, .height = 90, .noise = 0.1, .seed = 9}));
    const PlanningCase read = parse_case(text.str());
    const auto& grid = std::get<GridWorld>(read.model);
    ltl::Arena arena(grid.letters().vocabulary());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F (a & F b)", arena)), grid.letters());
    const auto product = GridBlock::Product::explore(grid, task);
    Unknowns unknowns{{}, StateSet(product->states(), false), {}};
    product->for_each_state([&](const auto& s) { unknowns.targets.set(s.index, product->is_goal(s)); });
    unknowns.unknown = almost_surely(*product, unknowns.targets);
    for (std::uint32_t i = 0; i < product->states(); ++i)
      if (unknowns.targets[i]) unknowns.unknown.erase(i);
    const auto values = [&](std::size_t on_grid) {
      const IterationOptions options{.tolerance = tolerance, .on_grid = on_grid};
      return ValueIteration<GridBlock::Product, Measure::MinCost>(*product, unknowns, options).run();
    };
    const auto in_place = values(0), written = values(SIZE_MAX);
    ASSERT_TRUE(in_place && written) << name(kind);
    std::size_t states = 0;
    for (std::uint32_t i = 0; i < product->states(); ++i) {
      if (!unknowns.unknown[i]) continue;
      ++states;
      ASSERT_LE(in_place->bounds.lower(i), written->bounds.upper(i) * rounding) << name(kind) << ", state " << i;
      ASSERT_GE(in_place->bounds.upper(i) * rounding, written->bounds.lower(i)) << name(kind) << ", state " << i;
      ASSERT_LE(in_place->bounds.upper(i), in_place->bounds.lower(i) * (1 + 2 * tolerance)) << name(kind);
    }
    EXPECT_GT(states, 8'000U) << "else there is one strip";
  }
}

// From a one has to go on to b at once. South of it is the edge of the grid, but no move goes south: none stays on a.
TEST(GridBlock, IsOfThisKindWhereNoMoveStaysOnALetter) {
  const ltl::Vocabulary names({"a", "b"});
  const std::vector<GridCell> palette{{}, {.label = {ltl::Proposition{0}}}, {.label = {ltl::Proposition{1}}}};
  GridWorld::Shape shape{.width = 6, .height = 5};
  const auto blocks = [&](const char* text, std::uint32_t a, std::uint32_t b) {
    std::vector<std::uint16_t> cells(30, 0);
    cells[a] = 1;
    cells[b] = 2;
    const GridWorld grid(shape, names, palette, cells, 29);
    ltl::Arena arena(names);
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse(text, arena)), grid.letters());
    return swept_in_place(GridBlock::Product::explore(grid, task).value());
  };
  EXPECT_EQ(blocks("!a U (a & X b)", 26, 20), 1U) << "to move south on a is to stay there, which is not to go on to b";
  EXPECT_EQ(blocks("F (a & X F b)", 14, 20), 2U);
  EXPECT_EQ(blocks("F (a & X F a)", 14, 20), 1U) << "the first a is where the second one is met";
  shape.motion[2] = {.forward = 0, .left = 0.5, .right = 0.5};
  EXPECT_EQ(blocks("!a U (a & X b)", 26, 20), 2U);
}

// A ring of 4 · side one-way cells round walls, with a door to the goal and one from the open, where most cells lie and
// moves slip.
GridWorld ring_of_one_way_cells(std::uint32_t side) {
  const std::uint32_t width = side + 10, height = 3 * (side + 1), open = side + 3;  // rows from there on
  std::vector<GridCell> palette{{}, {.wall = true}, {.label = {ltl::Proposition{0}}}};
  for (const Compass way : all_compass) palette.push_back({.one_way = way});
  std::vector<std::uint16_t> cells(std::size_t{width} * height, 1);
  std::fill(cells.begin() + std::ptrdiff_t{open} * width, cells.end(), std::uint16_t{0});
  const auto put = [&](std::uint32_t x, std::uint32_t y, std::uint16_t kind) { cells[y * width + x] = kind; };
  for (std::uint32_t i = 1; i < side; ++i) {
    put(i, 1, 4);  // east
    put(side, 1 + i, 5);
    put(i, side + 1, 6);
    put(0, 1 + i, 3);  // north
  }
  for (const std::uint32_t corner : {0U, side})
    for (const std::uint32_t y : {1U, side + 1}) put(corner, y, 0);
  put(3, 1, 0);
  put(3, 0, 2);         // the goal, north of it
  put(0, side + 2, 3);  // out of the open, not back
  constexpr SlipChances slips{.forward = 0.6, .left = 0.2, .right = 0.2};
  return GridWorld({.width = width, .height = height, .motion = {slips, slips, slips, slips}}, ltl::Vocabulary({"a"}),
                   palette, cells, width * height - 1);
}

// What lengthens steps in the open would let an error grow with every round of the ring: below nothing, and from there
// costs come back by a move a sweep.
TEST(GridBlock, SettlesOnARingOfOneWayCells) {
  for (const std::uint32_t side : {6U, ::waymark::testing::sanitized ? 6U : 50U}) {
    const GridWorld grid = ring_of_one_way_cells(side);
    ltl::Arena arena(grid.letters().vocabulary());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a", arena)), grid.letters());
    const auto product = GridBlock::Product::explore(grid, task);
    EXPECT_EQ(swept_in_place(*product), 1U);
    const auto found =
                   least_cost(*product, {.tolerance = tolerance, .sweeps = 2'000, .on_grid = 0, .second_way = false}),
               written = least_cost(*product, {.tolerance = tolerance, .on_grid = SIZE_MAX});
    ASSERT_TRUE(found && written) << side;
    EXPECT_LE(found->value.lower, written->value.upper * rounding) << side;
    EXPECT_GE(found->value.upper * rounding, written->value.lower) << side;
  }
}

// A row of cells between a hazard in the west and the goal in the east, and moves that go back as often as forward:
// the chance to arrive is the share of the way that is done.
struct FairWalk {
  explicit FairWalk(std::uint32_t length)
      : names({"a", "x"}),
        arena(names),
        grid({.width = length + 1, .height = 1, .motion = {back_or_on, back_or_on, back_or_on, back_or_on}}, names,
             {{}, {.label = {ltl::Proposition{0}}}, {.label = {ltl::Proposition{1}}}}, cells(length), length / 2),
        dfa(automata::ltlf_to_dfa(ltl::parse("!x U a", arena))),
        task(dfa, grid.letters()),
        product(GridBlock::Product::explore(grid, task).value()),
        unknowns{StateSet(product.states(), false), StateSet(product.states(), false), {}} {
    product.for_each_state([&](const auto& s) {
      (product.is_goal(s) ? unknowns.targets : unknowns.unknown).insert(s.index);
      truth.push_back(product.is_goal(s) ? 1 : product.compact(s).place / static_cast<double>(length));
    });
    for (std::size_t b = 0; b + 1 < product.blocks().size(); ++b) {
      const EndComponentQuotient<GridBlock::Product> merged(product, unknowns);
      if (order.states.empty()) order = merged.in_order(product.blocks()[b], product.blocks()[b + 1]);
    }
  }
  static std::vector<std::uint16_t> cells(std::uint32_t length) {
    std::vector<std::uint16_t> out(length + 1, 0);
    out.front() = 2;
    out.back() = 1;
    return out;
  }
  GridBlock block() const { return GridBlock::of(product, unknowns, Measure::MaxProbability, order).value(); }
  static constexpr SlipChances back_or_on{.forward = 0.5, .left = 0, .right = 0, .back = 0.5};
  ltl::Vocabulary names;
  ltl::Arena arena;
  GridWorld grid;
  automata::Dfa dfa;
  TaskTable task;
  GridBlock::Product product;
  Unknowns unknowns;
  GridBlock::Order order;
  std::vector<double> truth;  // by state
};

// Sweeps from above stop too high where runs are long: the lower bounds must be proved as well.
TEST(GridBlock, BoundsHoldWhateverIsClaimed) {
  const FairWalk walk(::waymark::testing::sanitized ? 40 : 120);
  for (const double factor : {0.0, 0.5, 3.0}) {
    std::vector<double> claimed = walk.truth;
    for (double& value : claimed) value = std::min(1.0, factor * value);
    GridBlock block = walk.block();
    block.start_from(claimed, tolerance);
    ASSERT_TRUE(block.solve({.tolerance = tolerance})) << factor;
    std::size_t states = 0;
    block.for_each([&](std::uint32_t i, double lower, double upper) {
      ++states;
      EXPECT_LE(lower, walk.truth[i] * rounding) << factor << " times the truth, state " << i;
      EXPECT_GE(upper * rounding, walk.truth[i]) << factor << " times the truth, state " << i;
      EXPECT_LE(upper - lower, tolerance) << factor << " times the truth, state " << i;
    });
    EXPECT_EQ(states, walk.order.states.size());
  }
}

// Two long rows, a strip each, with a goal north of every cell of one and a hazard south of every cell of the other.
// From either row a run comes into the other as often as to what is beyond: the chances are 2/3 and 1/3. Runs are so
// long that a sweep hardly changes what is wrong by the same everywhere.
TEST(GridBlock, BoundsOfStripsHoldWhateverIsClaimed) {
  constexpr std::uint32_t length = 2'500;
  constexpr double across = 1e-5, along = 0.5 - across, wide = 1e-3;  // wide: the tolerance
  std::vector<std::uint16_t> cells(std::size_t{4} * length, 0);
  std::fill_n(cells.begin(), length, std::uint16_t{1});
  std::fill_n(cells.begin() + std::ptrdiff_t{3} * length, length, std::uint16_t{2});
  constexpr SlipChances north{.forward = across, .left = along, .right = along, .back = across},
      east{.forward = along, .left = across, .right = across, .back = along};
  const ltl::Vocabulary names({"a", "x"});
  const GridWorld grid({.width = length, .height = 4, .motion = {north, east, north, east}}, names,
                       {{}, {.label = {ltl::Proposition{0}}}, {.label = {ltl::Proposition{1}}}}, cells, length);
  ltl::Arena arena(names);
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("!x U a", arena)), grid.letters());
  const auto product = GridBlock::Product::explore(grid, task).value();
  Unknowns unknowns{StateSet(product.states()), StateSet(product.states()), {}};
  std::vector<double> truth;
  product.for_each_state([&](const auto& s) {
    (product.is_goal(s) ? unknowns.targets : unknowns.unknown).insert(s.index);
    truth.push_back(product.is_goal(s) ? 1 : s.place < 2 * length ? 2.0 / 3 : 1.0 / 3);
  });
  const EndComponentQuotient<GridBlock::Product> merged(product, unknowns);
  const auto order = merged.in_order(0, product.states());
  ASSERT_EQ(order.states.size(), 2 * length);
  ASSERT_EQ(GridStrips(grid, order.states, order.chunk_size()).count(), 2U);
  for (const double wrong : {-0.25, 0.0, 0.1, 0.2}) {
    std::vector<double> claimed = truth;
    for (double& value : claimed) value = std::min(1.0, value + wrong * wide);
    GridBlock block = GridBlock::of(product, unknowns, Measure::MaxProbability, order).value();
    block.start_from(claimed, wide);
    const bool solved = block.solve({.tolerance = wide, .sweeps = 100}).has_value();
    EXPECT_TRUE(solved || wrong > -0.25) << "less than the truth by as much as is guessed";
    if (solved)
      block.for_each([&](std::uint32_t i, double lower, double upper) {
        ASSERT_LE(lower, truth[i] * rounding) << wrong << ", state " << i;
        ASSERT_GE(upper * rounding, truth[i]) << wrong << ", state " << i;
      });
  }
}

// Along a row between hazards there and back: who comes there has next to no chance of coming back, and that bounds
// what he had before.
TEST(GridBlock, TakesWhatIsAroundForABoundWhereItIsSmall) {
  constexpr std::uint32_t length = 40;
  const ltl::Vocabulary names({"a", "b", "x"});
  std::vector<std::uint16_t> cells(std::size_t{3} * length, 3);
  std::fill_n(cells.begin() + length, length, std::uint16_t{0});
  cells[length] = 2;
  cells[2 * length - 1] = 1;
  std::vector<GridCell> palette{{}};
  for (std::uint32_t p = 0; p < 3; ++p) palette.push_back({.label = {ltl::Proposition{p}}});
  constexpr SlipChances slips{.forward = 0.6, .left = 0.2, .right = 0.2};
  const GridWorld grid({.width = length, .height = 3, .motion = {slips, slips, slips, slips}}, names, palette, cells,
                       length + 2);
  ltl::Arena arena(names);
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("!x U (a & (!x U b))", arena)), grid.letters());
  const auto product = GridBlock::Product::explore(grid, task);
  const auto found = greatest_probability(*product, {.on_grid = 0}),
             written = greatest_probability(*product, {.on_grid = SIZE_MAX});
  ASSERT_TRUE(found && written);
  EXPECT_EQ(found->value.lower, 0);
  EXPECT_GT(found->value.upper, 0);
  EXPECT_LE(found->value.upper, 1e-6);
  EXPECT_LE(written->value.lower, found->value.upper);
  EXPECT_GT(written->value.lower, 0);
  EXPECT_LT(found->sweeps, 1'000U);
}

// Fewer sweeps than it takes: no answer; with as many the same answer, as soon as there is one.
TEST(GridBlock, GivesUpWhenItIsOutOfSweeps) {
  const FairWalk walk(12);
  const auto sweeps = walk.block().solve({.tolerance = tolerance});
  ASSERT_TRUE(sweeps);
  EXPECT_FALSE(walk.block().solve({.tolerance = tolerance, .sweeps = 0}));
  bool solved = false;
  for (std::uint64_t most = 0; most <= *sweeps; ++most) {
    const auto found = walk.block().solve({.tolerance = tolerance, .sweeps = most});
    EXPECT_TRUE(found || !solved) << most;
    solved = found.has_value();
    if (found) {
      EXPECT_EQ(*found, *sweeps) << most;
    }
  }
  EXPECT_TRUE(solved);
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(walk.block().solve({.tolerance = tolerance, .stop = source.get_token()}));
}

// A block that is out of sweeps has no values, and nor has the product.
TEST(GridBlock, LeavesNoValuesWhenItIsOutOfSweeps) {
  std::ostringstream text;
  write_case(text, generate_grid({.kind = GridKind::Scatter, .width = 20, .height = 20, .noise = 0.1, .seed = 4}));
  const PlanningCase read = parse_case(text.str());
  const auto& grid = std::get<GridWorld>(read.model);
  ltl::Arena arena(grid.letters().vocabulary());
  const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F (a & F b)", arena)), grid.letters());
  const auto product = GridBlock::Product::explore(grid, task);
  ASSERT_GT(swept_in_place(*product), 0U);
  IterationOptions options{.tolerance = tolerance, .on_grid = 0, .second_way = false};
  EXPECT_TRUE(least_cost(*product, options));
  options.sweeps = 1;
  EXPECT_FALSE(least_cost(*product, options));
}

}  // namespace
}  // namespace waymark::plan
