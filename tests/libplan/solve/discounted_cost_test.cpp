#include "libplan/solve/discounted_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libltl/structure/random.hpp"
#include "libplan/model/formats/prism_properties.hpp"
#include "libplan/solve/property_answer.hpp"
#include "tests/libplan/solve/random_models.hpp"

namespace waymark::plan {
namespace {

// Of one strategy without memory, by the sum of the series.
double series(const Mdp& mdp, const std::vector<std::uint32_t>& strategy, const DiscountedCosts& asked) {
  std::vector<double> now(mdp.states(), 0), next(mdp.states());
  for (int i = 0; i < 1'000; ++i) {
    for (std::uint32_t s = 0; s < mdp.states(); ++s) {
      next[s] = asked.ended[s] ? 0 : mdp.cost(s, strategy[s]);
      if (asked.ended[s]) continue;
      mdp.for_each_outcome(s, strategy[s],
                           [&](std::uint32_t t, LetterId, double p) { next[s] += asked.discount * p * now[t]; });
    }
    now.swap(next);
  }
  return now[mdp.initial()];
}

// Over all strategies without memory, of which one is best [Put94, Thm. 6.2.7].
double by_enumeration(const Mdp& mdp, const DiscountedCosts& asked) {
  std::vector<std::uint32_t> strategy(mdp.states(), 0);
  double best = asked.greatest ? -HUGE_VAL : HUGE_VAL;
  for (;;) {
    const double value = series(mdp, strategy, asked);
    best = asked.greatest ? std::max(best, value) : std::min(best, value);
    std::uint32_t s = 0;
    while (s < mdp.states() && ++strategy[s] == mdp.choices(s)) strategy[s++] = 0;
    if (s == mdp.states()) return best;
  }
}

TEST(DiscountedCost, IsThatOfTheBestStrategy) {
  ltl::Random random(11);
  int told_apart = 0;
  for (int i = 0; i < 60; ++i) {
    const Mdp mdp = testing::random_model(random, {.states = 2 + static_cast<std::uint32_t>(random.below(3))});
    double values[2]{};
    for (const bool greatest : {false, true}) {
      DiscountedCosts asked{static_cast<double>(random.below(10)) / 10, greatest, {}};
      for (std::uint32_t s = 0; s < mdp.states(); ++s) asked.ended.push_back(random.below(4) == 0);
      const double expected = by_enumeration(mdp, asked);
      const auto found = discounted_cost(mdp, asked, 1e-9);
      ASSERT_TRUE(found);
      EXPECT_LE(found->lower, expected + 1e-12) << testing::show(mdp);
      EXPECT_GE(found->upper, expected - 1e-12) << testing::show(mdp);
      EXPECT_LE(found->upper - found->lower, 1e-9 * std::max(1.0, expected)) << testing::show(mdp);
      values[greatest ? 1 : 0] = expected;
    }
    told_apart += values[0] != values[1] ? 1 : 0;
  }
  EXPECT_GT(told_apart, 20);
}

// Asked for no width at all, bounds are as far apart as rounding makes them, however small or great the costs are.
TEST(DiscountedCost, BoundsAreAsNearAsAskedForOrAsDoublesAre) {
  for (const double cost : {0.0, 1e-9, 1.0, 1e9}) {
    MdpBuilder builder(testing::vocabulary_ab());
    const LetterId none = builder.letter({});
    builder.add_state();
    builder.add_choice("on", cost);
    builder.add_outcome(0, none, 0.25);
    builder.add_outcome(1, none, 0.75);
    builder.add_state();
    builder.add_choice("back", 2 * cost);
    builder.add_outcome(0, none);
    const Mdp mdp = std::move(builder).build(0, none);
    // x = c + γ (x / 4 + 3 y / 4) and y = 2 c + γ x
    for (const double discount : {0.5, 0.99})
      for (const double tolerance : {0.0, 1e-6}) {
        const double expected = cost * (1 + 1.5 * discount) / (1 - discount / 4 - 0.75 * discount * discount);
        const auto found = discounted_cost(mdp, {.discount = discount}, tolerance);
        ASSERT_TRUE(found);
        EXPECT_LE(found->lower, expected) << cost << ' ' << discount << ' ' << tolerance;
        EXPECT_GE(found->upper, expected) << cost << ' ' << discount << ' ' << tolerance;
        EXPECT_LE(found->upper - found->lower, std::max(tolerance * std::max(1.0, expected), 1e-12 * expected))
            << cost << ' ' << discount << ' ' << tolerance;
      }
  }
}

TEST(DiscountedCost, NothingIsPaidWhereNothingCanBeDone) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({});
  builder.add_state();
  builder.add_choice("on", 3);
  builder.add_outcome(1, none);
  builder.add_state();
  const Mdp mdp = std::move(builder).build(0, none);
  for (const bool greatest : {false, true}) {
    const auto found = discounted_cost(mdp, {.discount = 0.5, .greatest = greatest}, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_LE(found->lower, 3);
    EXPECT_GE(found->upper, 3);
    EXPECT_LE(found->upper - found->lower, 1e-9);
  }
}

TEST(DiscountedCost, IsAskedForByProperties) {
  const std::string model = R"(mdp
module m
  s : [0..3] init 0;
  [risky] s=0 -> 0.5:(s'=1) + 0.5:(s'=2);
  [safe] s=0 -> (s'=1);
  [] s=1 -> (s'=1);
  [] s=2 -> (s'=2);
  [] s=3 -> (s'=0);
endmodule
rewards "r"
  [risky] s=0 : 1;
  [safe] s=0 : 100;
  s=2 : 5;
endrewards
)";
  const std::string questions = R"(
// RESULT: [23.4998,23.5002]
R{"r"}min=?[C{discount=0.9}]
// RESULT: 100.0
R{"r"}max=?[C{discount=0.9}]
// RESULT: [49.999,50.001]
filter(state, R{"r"}min=?[C{discount=0.9}], s=2)
// RESULT: 1
R{"r"}min=?[C{discount=0}]
// RESULT: 2.875
R{"r"}min=?[C{discount=0.5}<=3]
// RESULT: 100
R{"r"}min=?[C{discount=1}]
// RESULT: 1
R{"r"}min=?[F{discount=0.9} s=1 | s=2]
)";
  const auto parsed = parse_prism_properties({model, "m.nm"}, {questions, "q.props"});
  ASSERT_EQ(parsed.size(), 7U);
  for (const PrismProperty& p : parsed) {
    ASSERT_TRUE(p.fault.empty()) << p.text << p.fault;
    const PropertyAnswer found = answer(p, {});
    EXPECT_EQ(agrees(*p.result, found.answer.value.middle(), found.verdict), true)
        << p.text << ' ' << found.answer.value.middle();
  }
  for (const char* refused : {"C{discount=2}<=0", "C{discount=0.0/0.0}", "F{discount=0.5} X s=1"}) {
    const auto bad = parse_prism_properties({model, "m.nm"}, {"R{\"r\"}max=?[" + std::string(refused) + "]", "q"});
    ASSERT_EQ(bad.size(), 1U);
    EXPECT_FALSE(bad[0].fault.empty()) << refused;
  }
}

}  // namespace
}  // namespace waymark::plan
