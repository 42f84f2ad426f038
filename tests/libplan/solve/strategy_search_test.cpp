// Strategies that are hard to find: which choices count, and what is tried where the first strategy does not deliver.
#include <gtest/gtest.h>

#include <cmath>
#include <memory_resource>
#include <utility>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/solve/decide.hpp"
#include "tests/libplan/solve/random_models.hpp"

namespace waymark::plan {
namespace {

// Places and their choices; the goal shows `a`, gates show `b`.
struct Ways {
  struct Way {
    double cost;
    std::vector<std::pair<std::uint32_t, double>> outcomes;
  };
  std::vector<std::vector<Way>> of;  // by place
  std::uint32_t goal = 0;
  std::vector<std::uint32_t> gates = {};

  Mdp mdp() const {
    MdpBuilder builder(testing::vocabulary_ab());
    const LetterId nothing = builder.letter({}), there = builder.letter({ltl::Proposition{0}}),
                   through = builder.letter({ltl::Proposition{1}});
    std::vector<LetterId> shows(of.size(), nothing);
    shows[goal] = there;
    for (const std::uint32_t gate : gates) shows[gate] = through;
    for (const auto& ways : of) {
      builder.add_state();
      for (const Way& way : ways) {
        builder.add_choice("go", way.cost);
        for (const auto& [target, p] : way.outcomes) builder.add_outcome(target, shows[target], p);
      }
    }
    return std::move(builder).build(0, nothing);
  }
};

// The goal is asked for, after a gate where there are any.
struct Reached {
  explicit Reached(const Ways& ways) : mdp(ways.mdp()), task(dfa(!ways.gates.empty()), mdp.letters()) {
    product = ProductMdp<Mdp>::explore(mdp, task);
  }
  static automata::Dfa dfa(bool gates) {
    ltl::Arena arena(testing::vocabulary_ab());
    return automata::ltlf_to_dfa(ltl::parse(gates ? "F (b & F a)" : "F a", arena));
  }
  Mdp mdp;
  TaskTable task;
  std::optional<ProductMdp<Mdp>> product;
};

// Written out and swept, by policies, state by state.
std::vector<IterationOptions> three_ways(double tolerance) {
  return {{.tolerance = tolerance},
          {.tolerance = tolerance, .policy_iteration = true},
          {.tolerance = tolerance, .written_out = 0}};
}

// The hasty choice costs one and is likelier to arrive at once; but where it does not, nothing can be done any more.
TEST(StrategySearch, CostsKeepToWhatIsSure) {
  const Reached task({{{{1, {{1, 0.9}, {2, 0.1}}}, {5, {{1, 0.5}, {0, 0.5}}}}, {}, {{1, {{2, 1}}}}}, 1});
  for (const IterationOptions& limits : three_ways(1e-6)) {
    const auto found = least_cost(*task.product, limits);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value.middle(), 10, 1e-5);
    EXPECT_NEAR(found->re_evaluated.middle(), 10, 1e-5);
    EXPECT_TRUE(found->attained);
    EXPECT_EQ(found->strategy.choice[found->strategy.start], 1U);
  }
}

// A free circle between two places, by their second choices; their first ones lead to the goal.
TEST(StrategySearch, FreeCirclesAreFoundAmongAllChoices) {
  const Reached task({{{{5, {{2, 1}}}, {0, {{1, 1}}}}, {{6, {{2, 1}}}, {0, {{0, 1}}}}, {}}, 2});
  for (const IterationOptions& limits : three_ways(1e-6)) {
    const auto found = least_cost(*task.product, limits);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value.lower, 5, 1e-5);
    EXPECT_EQ(found->re_evaluated.upper, 5);
  }
}

// Bounds of a cost that is great beside the least step stand for nothing without a strategy: whichever choice it is.
TEST(StrategySearch, TheCheapestStepOfAnyChoiceCounts) {
  const Ways::Way pay{1e9, {{1, 1}}}, round{1, {{0, 1}}};
  for (const bool first : {false, true}) {
    const Reached task({{first ? std::vector{round, pay} : std::vector{pay, round}, {}}, 1});
    const auto found = least_cost(*task.product, {.strategy = false});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->strategy.choice.size(), task.product->states()) << first;
  }
}

// A fair walk to the goal from its other end.
Ways fair_walk(std::uint32_t places, double up = 0.5) {
  Ways out;
  for (std::uint32_t s = 0; s < places; ++s) out.of.push_back({{1, {{s + 1, up}, {s == 0 ? 0 : s - 1, 1 - up}}}});
  out.of.emplace_back();
  out.goal = places;
  return out;
}

// Coarser bounds would have been met by then: but it was sweeps that ended, not doubles.
TEST(StrategySearch, WhereSweepsEndBoundsAreNoCoarser) {
  const Reached task(fair_walk(20));
  IterationOptions limits{.tolerance = 1e-2, .written_out = 0};
  const auto coarse = least_cost(*task.product, limits);
  ASSERT_TRUE(coarse);
  limits.sweeps = coarse->sweeps;
  EXPECT_TRUE(least_cost(*task.product, limits));
  limits.tolerance = 1e-8;
  EXPECT_FALSE(least_cost(*task.product, limits));
}

// Between the places of a walk one moves for nothing, so its value is known at once, that of leaving at the far end;
// the strategy that walks there takes thousands of sweeps to evaluate.
TEST(StrategySearch, WhatTakesManySweepsToEvaluateIsLookedAtAgain) {
  constexpr std::uint32_t places = 40;
  Ways ways = fair_walk(places);
  ways.of[places] = {{1, {{places + 1, 0.5}, {places + 2, 0.5}}}};
  ways.of[places].push_back({1, {{places - 1, 1}}});
  ways.of.emplace_back();
  ways.of.push_back({{1, {{places + 2, 1}}}});
  ways.goal = places + 1;
  const Reached task(ways);
  const auto found = greatest_probability(*task.product, {.tolerance = 1e-4, .written_out = 0});
  ASSERT_TRUE(found);
  EXPECT_LT(found->sweeps, 10U);
  EXPECT_TRUE(found->attained);
  EXPECT_NEAR(found->re_evaluated.middle(), 0.5, 1e-4);
}

// Fifty places, from each of which a hasty choice goes on and may fail by a little less than what counts as the
// same, a sure one takes its time. `slow`: the last place is left once in a hundred thousand tries.
Ways hasty_and_sure(bool slow) {
  constexpr std::uint32_t places = 50, goal = places + 1, lost = places + 2;
  constexpr double risk = 0.9e-10;
  Ways out;
  for (std::uint32_t s = 0; s < places; ++s)
    out.of.push_back({{1, {{s + 1, 1 - risk}, {lost, risk}}}, {1, {{s + 1, 0.5}, {s, 0.5}}}});
  out.of.push_back({{1, {{goal, 0.5}, {lost, 0.5}}}});
  if (slow) out.of[places] = {{1, {{goal, 0.5e-5}, {lost, 0.5e-5}, {places, 1 - 1e-5}}}};
  out.of.emplace_back();
  out.of.push_back({{1, {{lost, 1}}}});
  out.goal = goal;
  return out;
}

TEST(StrategySearch, WhatIsLostInEveryStepIsFoundOut) {
  for (const bool slow : {false, true}) {
    const Reached task(hasty_and_sure(slow));
    for (const IterationOptions& limits : three_ways(1e-9)) {
      const auto found = greatest_probability(*task.product, limits);
      ASSERT_TRUE(found) << slow;
      EXPECT_TRUE(found->attained) << slow;
      EXPECT_GE(found->re_evaluated.lower, 0.5 - 2e-9) << slow;
      EXPECT_LE(found->re_evaluated.lower, 0.5 + 1e-9) << slow;
    }
  }
}

// The way over hasty choices ends in a fair walk, whose values take their time; beside it there is a gamble that is
// worth a millionth less. Only values that are a good deal finer than that tell.
TEST(StrategySearch, ValuesAreFineEnoughToTellWhatIsBetter) {
  constexpr double risk = 0.9e-10, loss = 1e-6;
  constexpr std::uint32_t hasty = 30, walk = 15, middle = 1 + hasty + walk / 2;
  constexpr std::uint32_t goal = 1 + hasty + walk, lost = goal + 1;
  Ways ways;
  ways.of.push_back({{1, {{goal, 0.5 - loss}, {lost, 0.5 + loss}}}, {1, {{1, 1}}}});
  for (std::uint32_t s = 1; s <= hasty; ++s) {
    const std::uint32_t next = s < hasty ? s + 1 : middle;
    ways.of.push_back({{1, {{next, 1 - risk}, {lost, risk}}}, {1, {{next, 0.5}, {s, 0.5}}}});
  }
  for (std::uint32_t s = 1 + hasty; s < goal; ++s)
    ways.of.push_back({{1, {{s + 1, 0.5}, {s > 1 + hasty ? s - 1 : lost, 0.5}}}});
  ways.of.emplace_back();
  ways.of.push_back({{1, {{lost, 1}}}});
  ways.goal = goal;
  const Reached task(ways);
  const auto found = greatest_probability(*task.product, {.tolerance = 1e-9, .written_out = 0});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->attained);
  EXPECT_NEAR(found->re_evaluated.middle(), 0.5, 2e-9);
}

// Memory that asks for a stop when arrays of values are made for so many times.
class StoppingMemory : public std::pmr::memory_resource {
 public:
  explicit StoppingMemory(int after) : left_(after) {}
  std::stop_token token() const { return source_.get_token(); }
  bool has_stopped() const { return source_.stop_requested(); }

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    if (--left_ == 0) source_.request_stop();
    return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  }
  void do_deallocate(void* p, std::size_t bytes, std::size_t alignment) override {
    std::pmr::new_delete_resource()->deallocate(p, bytes, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
  int left_;
  std::stop_source source_;
};

TEST(StrategySearch, StopsWhileAStrategyIsLookedFor) {
  const Reached task(hasty_and_sure(false));
  for (const int after : {1, 2}) {  // for the values; for finer ones, after two strategies that did not deliver
    StoppingMemory memory(after);
    const auto found =
        greatest_probability(*task.product, {.tolerance = 1e-9, .memory = &memory, .stop = memory.token()});
    EXPECT_TRUE(memory.has_stopped()) << after;
    EXPECT_FALSE(found) << after;
  }
}

// From the start one ends at once, with chance 1/2, or goes round: with chance `ends` a round ends, and then wins with
// chance 1/2 + more. The best is to go round, for as long as it takes, but a round gains next to nothing.
TEST(StrategySearch, BoundsHoldWhereABestStrategyGoesRoundForLong) {
  int found_some = 0;
  for (const auto& [ends, more] :
       {std::pair(1e-6, 4e-8), std::pair(1e-8, 4e-6), std::pair(1e-10, 4e-4), std::pair(1e-12, 4e-2)}) {
    constexpr std::uint32_t goal = 2, lost = 3;
    const double wins = ends * (0.5 + more), loses = ends * (0.5 - more);
    const Ways ways{{{{1, {{goal, 0.5}, {lost, 0.5}}}, {1, {{goal, wins}, {lost, loses}, {1, 1 - wins - loses}}}},
                     {{1, {{0, 1}}}},
                     {},
                     {{1, {{lost, 1}}}}},
                    goal};
    const Reached task(ways);
    for (const bool policies : {true, false}) {
      const auto found =
          greatest_probability(*task.product, {.tolerance = 1e-6, .policy_iteration = policies, .sweeps = 100'000});
      if (!found) continue;
      ++found_some;
      EXPECT_LE(found->value.lower, 0.5 + more + 1e-9) << "ends " << ends << ", by policies: " << policies;
      EXPECT_GE(found->value.upper, 0.5 + more - 1e-9) << "ends " << ends << ", by policies: " << policies;
    }
  }
  EXPECT_GT(found_some, 0);
}

}  // namespace
}  // namespace waymark::plan
