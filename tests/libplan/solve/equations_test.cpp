// Equations by sweeps and by policies, on systems whose values are known: also where the values of a policy are beyond
// what a double holds, and where a policy goes round for ever.
#include "libplan/solve/equations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libltl/structure/random.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

struct Term {
  std::uint32_t unknown;
  double chance;
};
struct Choice {
  double cost;
  std::vector<Term> terms;  // what is left to 1 leads to the end, which costs nothing
};
using Rows = std::vector<std::vector<Choice>>;

Equations costs(const Rows& rows) {
  Equations out(Measure::MinCost);
  for (const auto& choices : rows) {
    out.add_row();
    for (const Choice& choice : choices) {
      out.add_choice();
      double ends = 1;
      for (const Term& term : choice.terms) {
        out.add_term(term.unknown, term.chance);
        ends -= term.chance;
      }
      out.end_choice({.below = choice.cost,
                      .above = choice.cost,
                      .cost = choice.cost,
                      .least_known = ends > 0 ? 0 : std::numeric_limits<double>::infinity()});
    }
  }
  return out;
}

std::optional<Equations::Solution> solved(const Rows& rows, bool by_policies, std::uint64_t sweeps = 100'000) {
  IterationOptions options;
  options.policy_iteration = by_policies;
  options.sweeps = sweeps;
  return costs(rows).solve(options);
}

void expect_values(const Rows& rows, const std::vector<double>& expected, const std::string& what) {
  for (const bool by_policies : {false, true}) {
    const auto found = solved(rows, by_policies);
    ASSERT_TRUE(found) << what << (by_policies ? ", by policies" : ", by sweeps");
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LE(found->lower[i], expected[i] * (1 + 1e-12)) << what << ", row " << i;
      EXPECT_GE(found->upper[i], expected[i] * (1 - 1e-12)) << what << ", row " << i;
      EXPECT_LE(found->upper[i] - found->lower[i], 1e-6 * expected[i]) << what << ", row " << i;
    }
  }
}

TEST(Equations, AgreeWithFormulasInClosedForm) {
  expect_values({{{3, {}}}}, {3}, "one step");
  expect_values({{{1, {{0, 0.75}}}}}, {4}, "until it succeeds");
  expect_values({{{1, {{1, 1}}}}, {{1, {{2, 1}}}}, {{1, {}}}}, {3, 2, 1}, "a chain");
  expect_values({{{10, {}}, {1, {{1, 1}}}}, {{2, {{0, 0.5}}}}}, {4 / 0.5 * 0.75, 5}, "by the second choice");
  expect_values({{{1, {{0, 0.5}, {1, 0.25}}}}, {{1, {{0, 0.5}}}}}, {10.0 / 3, 8.0 / 3}, "two that lead to each other");
}

// A row of `length` steps of which each may lead back to its beginning: 2^(length + 1) − 2 steps in the mean, which no
// double holds when there are 1,100 of them.
Rows falling_back(std::uint32_t length) {
  Rows out;
  for (std::uint32_t i = 0; i < length; ++i) {
    Choice& choice = out.emplace_back().emplace_back(Choice{1, {{0, 0.5}}});
    if (i + 1 < length) choice.terms.push_back({i + 1, 0.5});
  }
  return out;
}

TEST(Equations, ValuesThatRoundingDecidesAreNoSolution) {
  for (const std::uint32_t length : {1U, 10U, 36U}) {
    const auto found = solved(falling_back(length), true);
    ASSERT_TRUE(found) << length;
    const double expected = std::ldexp(1, static_cast<int>(length) + 1) - 2;
    EXPECT_LE(found->lower[0], expected * (1 + 1e-12)) << length;
    EXPECT_GE(found->upper[0], expected * (1 - 1e-12)) << length;
  }
  for (const std::uint32_t length : {45U, 60U, 200U, 1'100U}) {
    const auto found = solved(falling_back(length), true, 300);
    EXPECT_FALSE(found) << length << ": " << found->lower[0] << " to " << found->upper[0];
  }
}

// Policies begin with the fewest steps to the end, which is the row of 1,100 that falls back. From each of its places a
// sure way leads to the end as well, and is longer by one.
TEST(Equations, APolicyWithoutFiniteValuesIsLeftForOneThatHasThem) {
  constexpr std::uint32_t length = 1'100;
  Rows rows = falling_back(length);
  for (auto& choices : rows) choices.push_back({1, {{length, 1}}});
  for (std::uint32_t i = 0; i < length; ++i) rows.push_back({{1, {}}});
  for (std::uint32_t i = 0; i + 1 < length; ++i) rows[length + i][0].terms.push_back({length + i + 1, 1});
  std::vector<double> expected(length, length + 1);
  for (std::uint32_t i = length; i-- > 1;)
    expected[i] = std::min(1.0 + length, 1 + 0.5 * expected[0] + (i + 1 < length ? 0.5 * expected[i + 1] : 0));
  expect_values(rows, expected, "a sure way beside it");
}

// A walk between two ends, up with chance p: the chance to end at the top is known in closed form, and a run may take
// thousands of steps. Of the ends something is known only between bounds.
struct RuinWalk {
  std::uint32_t length;
  double p, width;  // of what is known of the top
  double truth(std::uint32_t i) const {
    const double ratio = (1 - p) / p;
    return p == 0.5 ? i / static_cast<double>(length) : (1 - std::pow(ratio, i)) / (1 - std::pow(ratio, length));
  }
  std::optional<Equations::Solution> solved(bool by_policies, double tolerance) const {
    Equations out(Measure::MaxProbability);
    for (std::uint32_t i = 1; i < length; ++i) {  // row i - 1
      out.add_row();
      out.add_choice();  // to wait is of no use
      if (i > 1) out.add_term(i - 2, 0.5);
      out.end_choice({});
      out.add_choice();
      if (i > 1) out.add_term(i - 2, 1 - p);
      if (i + 1 < length) out.add_term(i, p);
      out.end_choice(i + 1 < length ? Equations::Constants{} : Equations::Constants{p * (1 - width), p});
    }
    return out.solve({.tolerance = tolerance, .policy_iteration = by_policies});
  }
};

TEST(Equations, GreatestProbabilitiesOfLongWalksLieBetweenTheBounds) {
  for (const RuinWalk& walk : {RuinWalk{10, 0.5, 0}, RuinWalk{60, 0.5, 1e-8}, RuinWalk{110, 0.5, 0},
                               RuinWalk{40, 0.45, 1e-8}, RuinWalk{100, 0.55, 1e-8}})
    for (const bool by_policies : {false, true}) {
      const auto found = walk.solved(by_policies, 1e-6);
      ASSERT_TRUE(found) << walk.length << (by_policies ? ", by policies" : ", by sweeps");
      for (std::uint32_t i = 1; i < walk.length; ++i) {
        const double truth = walk.truth(i);
        EXPECT_LE(found->lower[i - 1], truth * (1 - walk.width) + 1e-9) << walk.length << ", row " << i;
        EXPECT_GE(found->upper[i - 1], truth - 1e-9) << walk.length << ", row " << i;
        EXPECT_LE(found->upper[i - 1] - found->lower[i - 1], 1e-6) << walk.length << ", row " << i;
      }
    }
}

// What is known lies within bounds that are nearly as far apart as may be, or farther.
TEST(Equations, AreProvedWhereWhatIsKnownIsNarrowEnough) {
  for (const std::uint32_t length : {5U, 20U, 60U}) {
    const RuinWalk narrow{length, 0.5, 9e-7}, wide{length, 0.5, 1.3e-6};
    const auto found = narrow.solved(true, 1e-6);
    ASSERT_TRUE(found) << length;
    for (std::uint32_t i = 1; i < length; ++i) {
      EXPECT_LE(found->lower[i - 1], narrow.truth(i) * (1 - narrow.width) + 1e-12) << length << ", row " << i;
      EXPECT_GE(found->upper[i - 1], narrow.truth(i) - 1e-12) << length << ", row " << i;
      EXPECT_LE(found->upper[i - 1] - found->lower[i - 1], 1e-6) << length << ", row " << i;
    }
    EXPECT_FALSE(wide.solved(true, 1e-6)) << length;
  }
}

// Values of a policy by sweeps over it alone, the least over all policies: by definition.
std::vector<double> by_enumeration(const Rows& rows) {
  std::vector<double> best(rows.size(), INFINITY);
  std::vector<std::size_t> policy(rows.size(), 0);
  while (true) {
    std::vector<double> x(rows.size(), 0);
    for (int sweep = 0; sweep < 2'000; ++sweep)
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const Choice& choice = rows[i][policy[i]];
        double sum = choice.cost;
        for (const Term& term : choice.terms) sum += term.chance * x[term.unknown];
        x[i] = sum;
      }
    for (std::size_t i = 0; i < rows.size(); ++i) best[i] = std::min(best[i], x[i]);
    std::size_t i = 0;
    while (i < rows.size() && ++policy[i] == rows[i].size()) policy[i++] = 0;
    if (i == rows.size()) return best;
  }
}

TEST(Equations, LeastCostsAreThoseOfTheBestPolicy) {
  ltl::Random random(18);
  for (int trial = 0; trial < testing::scaled(300); ++trial) {
    Rows rows(1 + random.below(4));
    for (auto& choices : rows)
      for (std::size_t k = 0, many = 1 + random.below(3); k < many; ++k) {
        Choice& choice = choices.emplace_back();
        choice.cost = 1 + static_cast<double>(random.below(9));
        const std::size_t terms = random.below(3);
        for (std::size_t t = 0; t < terms; ++t)
          choice.terms.push_back({static_cast<std::uint32_t>(random.below(rows.size())), 0.45});
      }
    expect_values(rows, by_enumeration(rows), "seed 18, trial " + std::to_string(trial));
  }
}

// Rows of greatest probabilities, written out: constants below and above, and terms.
struct Offer {
  double below, above;
  std::vector<Term> terms;
};
std::optional<Equations::Solution> likeliest(const std::vector<std::vector<Offer>>& rows,
                                             const IterationOptions& options) {
  Equations out(Measure::MaxProbability);
  for (const auto& offers : rows) {
    out.add_row();
    for (const Offer& offer : offers) {
      out.add_choice();
      for (const Term& term : offer.terms) out.add_term(term.unknown, term.chance);
      out.end_choice({.below = offer.below, .above = offer.above});
    }
  }
  return out.solve(options);
}

// Rows with terms of the next one and of rows far behind: what a thread reads depends on how far the others are.
TEST(Equations, AreTheSameNumbersForAnyNumberOfThreads) {
  constexpr std::uint32_t size = 4'608;
  std::vector<std::vector<Offer>> rows(size);
  rows[0] = {{0.5, 0.5, {}}};
  for (std::uint32_t i = 1; i < size; ++i)
    for (const std::uint32_t step : {1'024U, 2'500U}) {
      const double known = 0.1 + 0.1 * std::sin(i + step);
      rows[i].push_back({known, known, {{(i + step) % size, 0.5}, {(i + 1) % size, 0.25}}});
    }
  const auto alone = likeliest(rows, {});
  ASSERT_TRUE(alone);
  for (const std::size_t threads : {2U, 4U}) {
    const auto together = likeliest(rows, {.sweepers = {.threads = threads}});
    ASSERT_TRUE(together) << threads;
    EXPECT_EQ(together->sweeps, alone->sweeps) << threads;
    EXPECT_TRUE(together->lower == alone->lower && together->upper == alone->upper) << threads;
  }
}

// Each row ends for good with chance 1/2 and leads to forty-six others. In doubles these chances add up to more than 1.
TEST(Equations, ProbabilitiesAreAtMostOneWhateverRoundingSays) {
  constexpr std::uint32_t others = 46;
  constexpr double chance = 0.5 / others;
  std::vector<std::vector<Offer>> rows(others + 1);
  double all = 0.5;
  for (std::uint32_t i = 0; i < others; ++i) all += chance;
  ASSERT_TRUE(raises(1, all)) << "else nothing is tried";
  for (std::uint32_t i = 0; i <= others; ++i) {
    Offer& offer = rows[i].emplace_back(Offer{0.5, 0.5, {}});
    for (std::uint32_t t = 0; t <= others; ++t)
      if (t != i) offer.terms.push_back({t, chance});
  }
  const auto found = likeliest(rows, {.tolerance = 1e-12});
  ASSERT_TRUE(found);
  EXPECT_LT(found->sweeps, 100U);
  for (const double upper : found->upper) EXPECT_EQ(upper, 1);
}

// To end costs 100. To go round costs hardly anything, but one ends by it once in many rounds only: what is gained in
// one is less than what policies are changed for, and yet the least cost is 95.
TEST(Equations, CostsOfAPolicyAreNoBoundsWhereRoundsAreCheaper) {
  for (const double ends : {1e-3, 1e-6, 1e-10})
    for (const bool first : {true, false})
      for (const bool by_policies : {true, false}) {
        const double step = 47.5 * ends, leaves = 1 - (1 - ends);  // in doubles
        const std::uint32_t round = first ? 1 : 0;
        Rows rows{{{100, {}}, {step, {{round, 1 - ends}}}}};
        rows.insert(first ? rows.end() : rows.begin(), std::vector<Choice>{{step, {{1 - round, 1}}}});
        const double truth = step * (2 - leaves) / leaves;
        const auto found = solved(rows, by_policies, 3'000);
        ASSERT_TRUE(found) << ends << ' ' << first << ' ' << by_policies;
        const double room = 1e-9 + 1e-15 / ends;  // what doubles leave of a round
        EXPECT_LE(found->lower[1 - round], truth * (1 + room)) << ends << ' ' << first << ' ' << by_policies;
        EXPECT_GE(found->upper[1 - round], truth * (1 - room)) << ends << ' ' << first << ' ' << by_policies;
      }
}

// A fair walk with a detour at every place, there and back for nothing, and a choice to give up. All ways round are
// worth what going on is; only a policy that goes on has values. From one that gives up it takes as many policies as
// there are places.
TEST(Equations, AmongEqualChoicesPoliciesGoOn) {
  constexpr std::uint32_t places = 250;
  std::vector<std::vector<Offer>> rows;
  for (std::uint32_t i = 1; i < places; ++i) {  // away from the end that is hoped for
    const std::uint32_t own = 2 * (i - 1);
    Offer on{0, 0, {}};
    if (i > 1)
      on.terms.push_back({own - 2, 0.5});
    else
      on.below = on.above = 0.5;
    if (i + 1 < places) on.terms.push_back({own + 2, 0.5});
    rows.push_back({{0, 0, {{own + 1, 1}}}, on, {0, 0, {}}});
    rows.push_back({{0, 0, {{own, 1}}}});
  }
  const auto found = likeliest(rows, {.sweeps = 3'000});
  ASSERT_TRUE(found);
  for (std::uint32_t i = 1; i < places; ++i) {
    const double truth = 1 - i / static_cast<double>(places);
    EXPECT_LE(found->lower[2 * std::size_t{i - 1}], truth + 1e-9) << i;
    EXPECT_GE(found->upper[2 * std::size_t{i - 1}], truth - 1e-9) << i;
  }
}

// What a choice would gain may be too little to change a policy for. All of it, and the width of what is known, counts
// in the proof, whichever row and choice it is of. `more`: the width of what is known of the choice that gains.
struct GainOfALittle {
  double truth(double more) const { return 0.5 + gain + more; }
  std::vector<std::vector<Offer>> rows(double more) const {
    constexpr double ends = 1e-10;
    const double known = 0.5 * ends + gain;
    return {{{0.5, 0.5, {}}, {known, known + more, {{1, 1 - ends}}}}, {{0.5, 0.5, {}}}};
  }
  double gain = 4.5e-14;
};

TEST(Equations, TheProofCountsTheGainsOfAllRows) {
  const GainOfALittle little;
  auto rows = little.rows(0);
  rows.push_back({{0.25, 0.25 + 9e-7, {}}});  // so that half of the tolerance is not enough
  const auto found = likeliest(rows, {.policy_iteration = true, .sweeps = 2'000});
  ASSERT_TRUE(found);
  EXPECT_GE(found->upper[0], little.truth(0));
  EXPECT_GE(found->upper[2], 0.25 + 9e-7);
}

TEST(Equations, BoundsFartherApartThanTheToleranceAreNoProof) {
  EXPECT_FALSE(likeliest({{{0.25, 0.25 + 1.2e-6, {}}}}, {.policy_iteration = true, .sweeps = 2'000}));
}

TEST(Equations, TheProofCountsTheWidthOfAllChoices) {
  const auto found = likeliest({{{0.25, 0.25 + 9e-7, {}}}, {{0.5, 0.5, {}}}}, {.policy_iteration = true});
  ASSERT_TRUE(found);
  EXPECT_GE(found->upper[0], 0.25 + 9e-7);
  EXPECT_LE(found->upper[0], 0.25 + 1e-6);
}

// Two that lead to each other: the second choice of the one ends now and then, by which a little more is gained than by
// its first one, in many rounds. `slow` rounds of two others say how long runs may take.
std::vector<std::vector<Offer>> rounds(double ends, double more, double slow) {
  const double known = ends * (0.5 + more);
  return {{{0.5, 0.5, {}}, {known, known, {{1, 1 - ends}}}},
          {{0, 0, {{0, 1}}}},
          {{slow / 2, slow / 2, {{3, 1 - slow}}}},
          {{0, 0, {{2, 1}}}}};
}

TEST(Equations, WhatIsGainedInRoundsIsCountedInAll) {
  constexpr double more = 8e-9;
  const auto found = likeliest(rounds(5.6e-6, more, 2e-3), {.tolerance = 1e-9, .policy_iteration = true});
  ASSERT_TRUE(found);
  EXPECT_LE(found->lower[0], 0.5 + more);
  EXPECT_GE(found->upper[0], 0.5 + more);
}

// Where sweeps raise a bound again and again, nothing is proved.
TEST(Equations, AProofWithoutEndIsNone) {
  const GainOfALittle little;
  auto rows = little.rows(2e-13);
  for (auto row : rounds(5.6e-8, 8e-7, 0.5)) {
    for (Offer& offer : row)
      for (Term& term : offer.terms) term.unknown += 2;
    rows.push_back(row);
  }
  const auto found = likeliest(rows, {.policy_iteration = true, .sweeps = 2'000});
  if (!found) return;
  EXPECT_GE(found->upper[0], little.truth(2e-13));
  EXPECT_GE(found->upper[2], 0.5 + 8e-7);
}

}  // namespace
}  // namespace waymark::plan
