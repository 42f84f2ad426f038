// Strategies of any kind on noisy grids: what sweeps in place say of them, against the chain written out and solved.
#include "libplan/solve/strategy_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libautomata/ltlf_to_dfa.hpp"
#include "libltl/parse.hpp"
#include "libplan/solve/markov_chain.hpp"
#include "libplan/solve/value_iteration.hpp"
#include "tests/libplan/solve/random_grids.hpp"

namespace waymark::plan {
namespace {

using Product = GridBlock::Product;
using Chain = StrategyChain<Product>;
constexpr std::uint64_t seed = 74;
constexpr double tolerance = 1e-6;
constexpr double rounding = 1 + 1e-9;  // of linear solves
constexpr std::uint64_t sweeps = 500;  // strategies drawn at random may take almost for ever: no answer then

// Sure to reach a goal (costs), or with some chance (probabilities).
template <Measure measure, class AnyChain>
Unknowns unknowns_of(const AnyChain& chain) {
  Unknowns out{{}, StateSet(chain.states(), false), {}};
  chain.for_each_state([&](const auto& s) { out.targets[s.index] = chain.is_goal(s); });
  out.unknown =
      measure == Measure::MinCost ? almost_surely(chain, out.targets) : can_reach(chain, out.targets);
  for (std::uint32_t i = 0; i < chain.states(); ++i)
    if (out.targets[i]) out.unknown[i] = false;
  return out;
}

Strategy random_strategy(const Product& product, ltl::Random& random) {
  Strategy out{std::vector<std::uint32_t>(product.states(), Strategy::none), product.starts().front()};
  product.for_each_state([&](const auto& s) {
    if (!product.is_goal(s)) out.choice[s.index] = static_cast<std::uint32_t>(random.below(4));
  });
  return out;
}

// visit(product, strategy, what it is): strategies of tasks whose blocks are swept in place, and of others.
template <class Visit>
void for_each_strategy(const Visit& visit) {
  ltl::Random random(seed);
  for (int round = 0; round < 30; ++round) {
    const GridWorld grid = testing::noisy_grid(random);
    for (const char* text : {"F (a & F b)", "!x U (a & (!x U b))", "F a & F b", "X X F b", "F (x & X !x)"}) {
      ltl::Arena arena(grid.letters().vocabulary());
      const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(text, arena));
      const TaskTable task(dfa, grid.letters());
      const auto product = Product::explore(grid, task);
      ASSERT_TRUE(product);
      if (product->starts().empty()) continue;
      visit(*product, random_strategy(*product, random),
            std::string(text) + "  round " + std::to_string(round) + "  seed " + std::to_string(seed));
      ASSERT_FALSE(::testing::Test::HasFailure());
    }
  }
}

TEST(StrategyChain, MeetsTheStatesOfTheChainWrittenOut) {
  for_each_strategy([](const Product& product, const Strategy& strategy, const std::string& what) {
    const Chain chain(product, strategy);
    const MarkovChain written(product, strategy);
    StateSet met(product.states(), false);
    for (std::uint32_t i = 0; i < written.states(); ++i) met[written.origin(i)] = true;
    StateSet visited(product.states(), false);
    chain.for_each_state([&](const auto& s) { visited[s.index] = true; });
    EXPECT_EQ(visited, met) << what;
  });
}

// Between the bounds, in place, lies what linear solves say of the written chain. Counts the values that say something.
template <Measure measure>
std::size_t compare(const Product& product, const Strategy& strategy, const std::string& what) {
  const Chain chain(product, strategy);
  const MarkovChain written(product, strategy);
  const Unknowns unknowns = unknowns_of<measure>(chain), same = unknowns_of<measure>(written);
  const auto found = ValueIteration<Chain, measure>(chain, unknowns,
                                                    {.tolerance = tolerance, .sweeps = sweeps, .on_grid = 0})
                         .run();
  const auto solved = ValueIteration<MarkovChain, measure>(
                          written, same, {.tolerance = tolerance, .sweeps = sweeps, .linear_solves = true})
                          .run();
  if (!found || !solved) return 0;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < written.states(); ++i) {
    const std::uint32_t o = written.origin(i);
    EXPECT_EQ(unknowns.unknown[o], same.unknown[i]) << what;
    EXPECT_LE(found->lower[o], solved->upper[i] * rounding) << what;
    EXPECT_GE(found->upper[o] * rounding, solved->lower[i]) << what;
    count += unknowns.unknown[o] ? 1 : 0;
  }
  return count;
}

TEST(StrategyChain, IsWorthWhatTheChainWrittenOutIs) {
  std::size_t chances = 0, costs = 0;
  for_each_strategy([&](const Product& product, const Strategy& strategy, const std::string& what) {
    chances += compare<Measure::MaxProbability>(product, strategy, what);
    costs += compare<Measure::MinCost>(product, strategy, what);
  });
  EXPECT_GT(chances, 500U);
  EXPECT_GT(costs, 100U);
}

// Costs, with the true bounds times `wrong` claimed of all states.
std::optional<Values> with_claim(const Chain& chain, const Unknowns& unknowns, const Values& exact,
                                 double wrong) {
  Values claimed = exact;
  for (double& x : claimed.lower) x *= wrong;
  for (double& x : claimed.upper) x *= wrong;
  return ValueIteration<Chain, Measure::MinCost>(
             chain, unknowns, {.tolerance = tolerance, .sweeps = sweeps, .on_grid = 0}, std::move(claimed))
      .run();
}

// What is claimed is checked: bounds that are too great from below, or too small from above, change nothing.
TEST(StrategyChain, TakesNoFalseClaims) {
  std::size_t tried = 0, sooner = 0;
  for_each_strategy([&](const Product& product, const Strategy& strategy, const std::string& what) {
    const Chain chain(product, strategy);
    const Unknowns unknowns = unknowns_of<Measure::MinCost>(chain);
    const IterationLimits limits{.tolerance = tolerance, .sweeps = sweeps, .on_grid = 0};
    const auto exact = ValueIteration<Chain, Measure::MinCost>(chain, unknowns, limits).run();
    if (!exact) return;
    for (double wrong : {0.5, 1.0, 2.0}) {
      const auto found = with_claim(chain, unknowns, *exact, wrong);
      ASSERT_TRUE(found) << what;
      for (std::uint32_t i = 0; i < product.states(); ++i) {
        EXPECT_LE(found->lower[i], exact->upper[i] * rounding) << what << "  claim " << wrong;
        EXPECT_GE(found->upper[i] * rounding, exact->lower[i]) << what << "  claim " << wrong;
        EXPECT_LE(found->upper[i], found->lower[i] * (1 + 4 * tolerance)) << what << "  claim " << wrong;
        tried += unknowns.unknown[i] ? 1 : 0;
      }
      sooner += wrong == 1.0 && found->sweeps < exact->sweeps ? 1 : 0;
    }
  });
  EXPECT_GT(tried, 300U);
  EXPECT_GT(sooner, 10U);
}

}  // namespace
}  // namespace waymark::plan
