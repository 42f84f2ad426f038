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
    const RuinWalk narrow{length, 0.5, 9e-7}, wide{length, 0.5, 1.2e-6};
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

}  // namespace
}  // namespace waymark::plan
