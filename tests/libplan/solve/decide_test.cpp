// Values and strategies, against sweeps without refinement on products written out state by state.
#include "libplan/solve/decide.hpp"

#include <gtest/gtest.h>

#include <array>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libautomata/limit_deterministic/mdp_referee.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using testing::Plainly;
using waymark::testing::scaled;

constexpr double tolerance = 1e-6;

// Sweeps of equations that are written out, policies by linear solves, and sweeps of the product as it is.
const std::array<IterationOptions, 3> ways{IterationOptions{.tolerance = tolerance},
                                           IterationOptions{.tolerance = tolerance, .policy_iteration = true},
                                           IterationOptions{.tolerance = tolerance, .written_out = 0}};

// A process with labels on states, as the referee of the automata's tests has it.
Mdp mdp_of(const automata::referee::World& world) {
  MdpBuilder builder(testing::vocabulary_ab());
  for (const auto& actions : world.actions) {
    builder.add_state();
    for (const auto& moves : actions) {
      builder.add_choice("go");
      for (const auto& move : moves)
        builder.add_outcome(move.target, builder.letter(world.label[move.target]), move.probability);
    }
  }
  const LetterId first = builder.letter(world.label[0]);
  return std::move(builder).build(0, first);
}

void expect_bounds(const Decided& decided, double expected, double room, const std::string& what) {
  EXPECT_LE(decided.value.lower, expected + 1e-9) << what;
  EXPECT_GE(decided.value.upper, expected - 1e-9) << what;
  EXPECT_LE(decided.value.upper - decided.value.lower, room) << what;
  EXPECT_NEAR(decided.re_evaluated.middle(), expected, 2 * room) << what;
  EXPECT_LT(decided.sweeps, 1'000'000U) << what;
}

TEST(Decide, GreatestProbabilitiesOfFormulasAgreeWithTheReferee) {
  constexpr std::uint64_t seed = 5;
  ltl::Random random(seed);
  int proper = 0;
  for (int i = 0; i < scaled(300); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2});
    const automata::Dpa dpa = automata::ltl_to_dpa(f);
    const automata::MdpSafe ldba = automata::ltl_to_ldba(f);
    for (int j = 0; j < 4; ++j) {
      const auto world = automata::referee::random_world(random, 2 + static_cast<std::uint32_t>(random.below(4)),
                                                         {ltl::Proposition{0}, ltl::Proposition{1}});
      const double expected = automata::referee::greatest_probability(world, dpa);
      const Mdp mdp = mdp_of(world);
      const TaskTable task(ldba, mdp.letters());
      const auto product = ProductMdp<Mdp>::explore(mdp, task);
      for (const IterationOptions& limits : ways) {
        const auto decided = greatest_probability(*product, limits);
        ASSERT_TRUE(decided);
        expect_bounds(*decided, expected, tolerance,
                      ltl::print(f) + " on\n" + testing::show(mdp) + "seed " + std::to_string(seed));
        ASSERT_FALSE(HasFailure());
      }
      proper += expected > 1e-6 && expected < 1 - 1e-6 ? 1 : 0;
    }
  }
  EXPECT_GT(proper, waymark::testing::sanitized ? 0 : 20);  // else nothing was tried
}

struct FiniteTask {
  FiniteTask(ltl::Random& random, const testing::RandomModel& shape)
      : arena(testing::vocabulary_ab()),
        formula(ltl::random_formula(random, arena, {.size = 5 + random.below(10), .atoms = 2})),
        dfa(automata::ltlf_to_dfa(formula)),
        mdp(testing::random_model(random, shape)),
        task(dfa, mdp.letters()),
        never(TaskTable::never(dfa, mdp.letters())),
        product(ProductMdp<Mdp>::explore(mdp, task)),
        without(ProductMdp<Mdp>::explore(mdp, never)) {}
  std::string show() const { return ltl::print(formula) + " on\n" + testing::show(mdp); }
  ltl::Arena arena;
  ltl::Formula formula;
  automata::Dfa dfa;
  Mdp mdp;
  TaskTable task, never;
  std::optional<ProductMdp<Mdp>> product, without;  // of the task, and of its opposite
};

TEST(Decide, ProbabilitiesOfFiniteTasksAgreeWithPlainSweeps) {
  ltl::Random random(6);
  int proper = 0;
  for (int i = 0; i < scaled(400); ++i) {
    const FiniteTask t(random, {.states = 3 + static_cast<std::uint32_t>(random.below(4))});
    const double greatest = Plainly(t.mdp, t.dfa).probability(Plainly::Best::Greatest);
    const double least = Plainly(t.mdp, t.dfa).probability(Plainly::Best::Least);
    for (const IterationOptions& limits : ways) {
      const auto most = greatest_probability(*t.product, limits), none = greatest_probability(*t.without, limits);
      ASSERT_TRUE(most && none) << t.show();
      if (!t.product->starts().empty()) expect_bounds(*most, greatest, tolerance, t.show());
      expect_bounds(*none, 1 - least, tolerance, t.show());
      EXPECT_EQ(most->value.upper == 0, greatest < 1e-9) << t.show();
      ASSERT_FALSE(HasFailure());
    }
    proper += greatest > 1e-6 && least < 1 - 1e-6 && (greatest < 1 - 1e-6 || least > 1e-6) ? 1 : 0;
  }
  EXPECT_GT(proper, waymark::testing::sanitized ? 0 : 20);
}

TEST(Decide, LeastCostsAgreeWithPlainSweeps) {
  ltl::Random random(7);
  int proper = 0;
  for (int i = 0; i < (waymark::testing::sanitized ? 30 : 500); ++i) {
    const bool unit = random.below(2) == 0;
    const FiniteTask t(random, {.states = 2 + static_cast<std::uint32_t>(random.below(3)), .unit_costs = unit});
    if (!unit) {  // costs of zero let plain sweeps from below stop too low where one can go round for nothing
      bool free = false;
      for (std::uint32_t s = 0; s < t.mdp.states(); ++s)
        for (std::uint32_t k = 0; k < t.mdp.choices(s); ++k) free = free || t.mdp.cost(s, k) == 0;
      if (free) continue;
    }
    const double expected = Plainly(t.mdp, t.dfa).cost();
    for (const IterationOptions& limits : ways) {
      const auto decided = least_cost(*t.product, limits);
      ASSERT_TRUE(decided) << t.show();
      if (std::isinf(expected)) {
        EXPECT_TRUE(std::isinf(decided->value.lower)) << t.show();
      } else {
        expect_bounds(*decided, expected, tolerance * std::max(1.0, expected), t.show());
        IterationOptions alone = limits;
        alone.strategy = false;
        const auto value = least_cost(*t.product, alone);
        ASSERT_TRUE(value) << t.show();
        expect_bounds(*value, expected, tolerance * std::max(1.0, expected), t.show() + "  without a strategy");
        EXPECT_EQ(value->strategy.choice.size(), 0U) << t.show();
        proper += expected > 0 ? 1 : 0;
      }
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(proper, waymark::testing::sanitized ? 0 : 30);
}

// A free circle beside the way: values from below would stay at zero for ever.
TEST(Decide, GoingRoundForNothingIsNoProgress) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("round", 0);
  builder.add_outcome(1, nothing);
  builder.add_choice("pay", 5);
  builder.add_outcome(2, there);
  builder.add_state();
  builder.add_choice("round", 0);
  builder.add_outcome(0, nothing);
  builder.add_state();
  builder.add_choice("stay", 1);
  builder.add_outcome(2, there);
  const Mdp mdp = std::move(builder).build(0, nothing);
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F a", arena));
  const TaskTable task(dfa, mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  for (const IterationOptions& limits : ways) {
    const auto decided = least_cost(*product, limits);
    ASSERT_TRUE(decided);
    EXPECT_NEAR(decided->value.lower, 5, 1e-5);
    EXPECT_EQ(decided->re_evaluated.upper, 5);
    EXPECT_EQ(decided->strategy.choice[decided->strategy.start], 1U);
    IterationOptions alone = limits;
    alone.strategy = false;
    const auto value = least_cost(*product, alone);
    ASSERT_TRUE(value);
    EXPECT_NEAR(value->value.lower, 5, 1e-5);
    EXPECT_EQ(value->strategy.choice.size(), product->states()) << "where moves are free, bounds need a strategy";
  }
}

// A bound of a cost stands alone where steps of the unknowns, few beside it, cost something. Those of goals do not
// count.
TEST(Decide, CostsNeedAStrategyWhereStepsAreMany) {
  for (const double cost : {1e7, 1e9}) {
    MdpBuilder builder(testing::vocabulary_ab());
    const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}});
    builder.add_state();
    builder.add_choice("round", 1);
    builder.add_outcome(0, nothing);
    builder.add_choice("pay", cost);
    builder.add_outcome(1, there);
    builder.add_state();
    builder.add_choice("stay", 0);
    builder.add_outcome(1, there);
    const Mdp mdp = std::move(builder).build(0, nothing);
    ltl::Arena arena(testing::vocabulary_ab());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a", arena)), mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    const auto value = least_cost(*product, {.tolerance = 1e-6, .strategy = false});
    ASSERT_TRUE(value);
    EXPECT_EQ(value->strategy.choice.size(), cost < 1e8 ? 0U : product->states()) << cost;
    EXPECT_NEAR(value->value.middle(), cost, cost * 1e-6);
  }
}

// A walk of eight places against the drift: many sweeps, few policies.
TEST(Decide, PolicyIterationSolvesWhereOthersSweep) {
  constexpr std::uint32_t places = 8;
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}});
  for (std::uint32_t s = 0; s < places; ++s) {
    builder.add_state();
    builder.add_choice("on");
    builder.add_outcome(s + 1, s + 1 == places ? there : nothing, 0.4);
    builder.add_outcome(s == 0 ? 0 : s - 1, nothing, 0.6);
  }
  builder.add_state();
  builder.add_choice("stay");
  builder.add_outcome(places, there);
  const Mdp mdp = std::move(builder).build(0, nothing);
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F a", arena));
  const TaskTable task(dfa, mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  for (IterationOptions limits : ways) {
    limits.sweeps = 0;
    EXPECT_EQ(least_cost(*product, limits).has_value(), limits.policy_iteration) << "out of sweeps";
    limits.sweeps = UINT64_MAX;
    std::stop_source source;
    source.request_stop();
    limits.stop = source.get_token();
    EXPECT_FALSE(least_cost(*product, limits)) << "stopped";
  }
  const auto policies = least_cost(*product, ways[1]), sweeps = least_cost(*product, ways[2]);
  ASSERT_TRUE(policies && sweeps);
  EXPECT_LT(4 * policies->sweeps, sweeps->sweeps);
  EXPECT_NEAR(policies->value.middle(), sweeps->value.middle(), 1e-6 * sweeps->value.middle());
}

// A fair walk of twenty places, and at the start a choice that is worth less than to walk on: with a coarse tolerance
// that is taken, and what it is worth bounds the value from below alone.
TEST(Decide, BoundsHoldAtCoarseTolerances) {
  constexpr std::uint32_t places = 20, start = 18;
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}});
  for (std::uint32_t s = 0; s <= places; ++s) {
    builder.add_state();
    const bool ends = s == 0 || s == places;
    builder.add_choice("walk");
    builder.add_outcome(ends ? s : s + 1, s + 1 == places ? there : nothing, 0.5);
    builder.add_outcome(ends ? s : s - 1, nothing, 0.5);
    if (s != start) continue;
    builder.add_choice("jump");
    builder.add_outcome(places, there, 0.895);
    builder.add_outcome(0, nothing, 0.105);
  }
  const Mdp mdp = std::move(builder).build(start, nothing);
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F a", arena));
  const TaskTable task(dfa, mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  for (IterationOptions limits : ways) {
    limits.tolerance = 0.9;
    const auto decided = greatest_probability(*product, limits);
    ASSERT_TRUE(decided);
    EXPECT_LE(decided->value.lower, 0.9 + 1e-9);
    EXPECT_GE(decided->value.upper, 0.9 - 1e-9);
    EXPECT_LE(decided->value.upper - decided->value.lower, 0.9);
    if (limits.written_out == 0) {
      EXPECT_NEAR(decided->re_evaluated.middle(), 0.895, 1e-9) << "else nothing was tried";
    }
  }
  EXPECT_EQ((Bounds{0.5, 1.5}).middle(), 1);
}

// In the winning component the likeliest way to the mark may lead out of it.
TEST(Decide, WhatIsMetForEverIsMetWithoutRisk) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId nothing = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("risk");
  builder.add_outcome(1, nothing, 0.9);
  builder.add_outcome(2, nothing, 0.1);
  builder.add_choice("wait");
  builder.add_outcome(1, nothing, 0.5);
  builder.add_outcome(0, nothing, 0.5);
  builder.add_state();
  builder.add_choice("back");
  builder.add_outcome(0, a);
  builder.add_state();
  builder.add_choice("stay");
  builder.add_outcome(2, nothing);
  const Mdp mdp = std::move(builder).build(0, nothing);
  ltl::Arena arena(testing::vocabulary_ab());
  const automata::MdpSafe ldba = automata::ltl_to_ldba(ltl::parse("G F a", arena));
  const TaskTable task(ldba, mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  const auto decided = greatest_probability(*product, ways[0]);
  ASSERT_TRUE(decided);
  EXPECT_EQ(decided->value.lower, 1);
  EXPECT_EQ(decided->re_evaluated.lower, 1);
}

// Every choice twice, its outcomes in the opposite order: worth the same, and not quite the same in doubles.
Mdp twofold(ltl::Random& random, std::uint32_t states) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}});
  for (std::uint32_t s = 0; s < states; ++s) {  // the last is the goal, the first is left for nowhere now and then
    builder.add_state();
    std::vector<std::uint32_t> targets;
    for (int i = 0; i < 4; ++i) targets.push_back(static_cast<std::uint32_t>(random.below(states)));
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(targets.begin(), targets.end());
      builder.add_choice(reversed ? "back" : "on", 1.0 + s);
      for (std::size_t i = 0; i < 4; ++i)
        builder.add_outcome(targets[i], targets[i] + 1 == states ? there : nothing,
                            static_cast<double>(reversed ? 4 - i : i + 1) / 10);
    }
  }
  return std::move(builder).build(0, nothing);
}

// Bounds finer than doubles are: what is said of them, and of the strategy, is what they are.
TEST(Decide, SaysHowWideBoundsAreAndWhetherTheyAreAttained) {
  ltl::Random random(8);
  int attained = 0, missed = 0;
  for (int i = 0; i < scaled(200); ++i) {
    const Mdp mdp = twofold(random, 4 + static_cast<std::uint32_t>(random.below(4)));
    ltl::Arena arena(testing::vocabulary_ab());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F a", arena)), mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    for (IterationOptions limits : ways) {
      limits.tolerance = 1e-17;
      const auto cost = least_cost(*product, limits);
      if (!cost || std::isinf(cost->value.lower)) continue;
      EXPECT_LE(cost->value.upper, cost->value.lower * (1 + cost->tolerance + 1e-15)) << testing::show(mdp);
      EXPECT_EQ(cost->attained,
                cost->re_evaluated.upper <= cost->value.upper + cost->tolerance * std::max(1.0, cost->value.upper))
          << testing::show(mdp);
      ++(cost->attained ? attained : missed);
      EXPECT_EQ(cost->tolerance, limits.tolerance);
    }
  }
  EXPECT_GT(attained, 0);
  EXPECT_GT(missed, 0);
}

// One move to the goal: what each way takes to see that the first sweep was right.
TEST(Decide, CountsSweeps) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("on");
  builder.add_outcome(1, there);
  builder.add_state();
  builder.add_choice("stay");
  builder.add_outcome(1, there);
  const Mdp mdp = std::move(builder).build(0, nothing);
  const auto sweeps = [&](const char* formula, const IterationOptions& limits) {
    ltl::Arena arena(testing::vocabulary_ab());
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(formula, arena));
    const TaskTable task(dfa, mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    const auto cost = least_cost(*product, limits), most = greatest_probability(*product, limits);
    EXPECT_TRUE(cost && most) << formula;
    EXPECT_EQ(most->sweeps, 0U) << formula << ": by the graph alone";
    const double width = product->starts().empty() ? 0 : limits.tolerance;  // else the answer is exact
    EXPECT_EQ(most->tolerance, width) << formula;
    EXPECT_EQ(cost->tolerance, width) << formula;
    EXPECT_TRUE(cost->attained && most->attained) << formula;
    return cost->sweeps;
  };
  EXPECT_EQ(sweeps("F a", ways[0]), 1U) << "from the best luck, which is the value";
  EXPECT_EQ(sweeps("F a", ways[1]), 1U) << "one policy";
  EXPECT_EQ(sweeps("F a", ways[2]), 3U) << "up, no further, and a proof";
  EXPECT_EQ(sweeps("!a", ways[0]), 0U) << "done at the start";
  EXPECT_EQ(sweeps("G b", ways[0]), 0U) << "lost at the start";
}

}  // namespace
}  // namespace waymark::plan
