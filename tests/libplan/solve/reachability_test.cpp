// Which states reach a target, and which do so almost surely: against every policy of small products.
#include "libplan/solve/reachability.hpp"

#include <gtest/gtest.h>

#include "tests/libplan/solve/every_policy.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using testing::SmallProduct;

// The greatest part of a set in which each state is a target or has a choice that keeps inside: union of all such.
StateSet safe_part(const SmallProduct& product, const StateSet& targets, const StateSet& set) {
  StateSet out(product.states(), false);
  for (std::uint32_t bits = 0; bits < 1U << product.states(); ++bits) {
    StateSet part(product.states());
    for (std::uint32_t i = 0; i < product.states(); ++i) part.set(i, ((bits >> i) & 1U) != 0);
    bool safe = true;
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      if (!part[i]) continue;
      bool kept = targets[i];
      for (std::uint32_t k = 0; k < product.of[i].size(); ++k) kept = kept || all_outcomes_in(product, {i}, k, part);
      safe = safe && set[i] && kept;
    }
    for (std::uint32_t i = 0; i < product.states(); ++i)
      if (safe && part[i]) out.insert(i);
  }
  return out;
}

TEST(Reachability, IsThatOfAllPolicies) {
  ltl::Random random(101);
  int between = 0, never = 0;
  for (int trial = 0; trial < waymark::testing::scaled(3'000); ++trial) {
    const SmallProduct product = testing::small_product(random, static_cast<std::uint32_t>(1 + random.below(6)));
    const StateSet targets = testing::random_states(random, product.states(), 4);
    const std::vector<double> chance = testing::best_values(product, targets).chance;
    const auto [some, sure] = reaching(product, targets);
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      ASSERT_EQ(some[i], chance[i] > 1e-9) << "trial " << trial << ", state " << i << "\n" << testing::show(product);
      ASSERT_EQ(sure[i], chance[i] > 1 - 1e-9) << "trial " << trial << ", state " << i << "\n"
                                               << testing::show(product);
      between += some[i] && !sure[i] ? 1 : 0;
      never += some[i] ? 0 : 1;
    }
    ASSERT_EQ(can_reach(product, targets), some);
    ASSERT_EQ(almost_surely(product, targets), sure);
  }
  EXPECT_GT(between, waymark::testing::scaled(300));
  EXPECT_GT(never, waymark::testing::scaled(1'000));
}

TEST(Reachability, WhatIsKeptSafeIsTheGreatestSuchPart) {
  ltl::Random random(102);
  int smaller = 0, closed_ones = 0;
  for (int trial = 0; trial < waymark::testing::scaled(2'000); ++trial) {
    const SmallProduct product = testing::small_product(random, static_cast<std::uint32_t>(1 + random.below(6)));
    const StateSet targets = testing::random_states(random, product.states(), 5);
    StateSet set = testing::random_states(random, product.states(), 2);
    if (random.below(3) == 0) set = StateSet(product.states(), true);
    bool leads_out = false;
    for (std::uint32_t i = 0; i < product.states(); ++i)
      for (const SmallProduct::Choice& choice : product.of[i])
        for (const SmallProduct::Outcome& o : choice.outcomes)
          leads_out = leads_out || (set[i] && (o.target == SmallProduct::trap || !set[o.target]));
    ASSERT_EQ(closed(product, set), !leads_out) << "trial " << trial << "\n" << testing::show(product);
    closed_ones += leads_out ? 0 : 1;
    StateSet kept = set;
    keep_safe(product, targets, kept);
    ASSERT_EQ(kept, safe_part(product, targets, set)) << "trial " << trial << "\n" << testing::show(product);
    smaller += kept == set ? 0 : 1;
  }
  EXPECT_GT(smaller, waymark::testing::scaled(500));
  EXPECT_GT(closed_ones, waymark::testing::scaled(200));
}

TEST(Reachability, OutcomesAreLookedAtOneByOne) {
  const SmallProduct product{{{{1, {{0, 0.5}, {1, 0.5}}}, {1, {{1, 0.5}, {SmallProduct::trap, 0.5}}}}, {}}, {0, 2}};
  const StateSet none(2), both(2, true);
  StateSet first(2), second(2);
  first.insert(0);
  second.insert(1);
  EXPECT_FALSE(some_outcome_in(product, {0}, 0, none));
  EXPECT_TRUE(some_outcome_in(product, {0}, 0, first));
  EXPECT_TRUE(some_outcome_in(product, {0}, 0, second));
  EXPECT_FALSE(some_outcome_in(product, {0}, 1, first));
  EXPECT_FALSE(all_outcomes_in(product, {0}, 0, first));
  EXPECT_FALSE(all_outcomes_in(product, {0}, 0, second));
  EXPECT_TRUE(all_outcomes_in(product, {0}, 0, both));
  EXPECT_FALSE(all_outcomes_in(product, {0}, 1, both));
  std::vector<std::uint32_t> told;
  for_each_target(product, SmallProduct::State{0}, [&](std::uint32_t t) { told.push_back(t); });
  EXPECT_EQ(told, (std::vector<std::uint32_t>{0, 1, 1, SmallProduct::trap}));
}

}  // namespace
}  // namespace waymark::plan
