// Strategies of any kind on noisy grids: what sweeps in place say of them, against the chain written out and solved.
#include "libplan/solve/strategy_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/solve/case_task.hpp"
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
  chain.for_each_state([&](const auto& s) { out.targets.set(s.index, chain.is_goal(s)); });
  out.unknown = measure == Measure::MinCost ? almost_surely(chain, out.targets) : can_reach(chain, out.targets);
  for (std::uint32_t i = 0; i < chain.states(); ++i)
    if (out.targets[i]) out.unknown.erase(i);
  return out;
}

Strategy random_strategy(const Product& product, ltl::Random& random) {
  Strategy out{Choices(product.states()), product.starts().front()};
  product.for_each_state([&](const auto& s) {
    if (!product.is_goal(s)) out.choice.set(s.index, static_cast<std::uint32_t>(random.below(4)));
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
    for (std::uint32_t i = 0; i < written.states(); ++i) met.insert(written.origin(i));
    StateSet visited(product.states(), false);
    chain.for_each_state([&](const auto& s) { visited.insert(s.index); });
    EXPECT_EQ(visited, met) << what;
    using Outcome = std::tuple<std::uint32_t, double, bool>;  // number of the product, chance, is it marked
    written.for_each_state([&](const MarkovChain::State& s) {
      const Product::State origin = product.state(written.origin(s.index));
      EXPECT_EQ(written.choices(s), chain.choices(origin)) << what;
      EXPECT_EQ(written.cost(s, 0), chain.cost(origin, 0)) << what;
      std::vector<Outcome> own, others;
      written.for_each_outcome(s, 0, [&](std::uint32_t t, double p, bool marked) {
        own.emplace_back(t == MarkovChain::trap ? Product::trap : written.origin(t), p, marked);
      });
      chain.for_each_outcome(origin, 0,
                             [&](std::uint32_t t, double p, bool marked) { others.emplace_back(t, p, marked); });
      EXPECT_EQ(own, others) << what << ", state " << origin.index;
    });
  });
}

// Between the bounds, in place, lies what linear solves say of the written chain. Counts the values that say something.
template <Measure measure>
std::size_t compare(const Product& product, const Strategy& strategy, const std::string& what) {
  const Chain chain(product, strategy);
  const MarkovChain written(product, strategy);
  const Unknowns unknowns = unknowns_of<measure>(chain), same = unknowns_of<measure>(written);
  const auto found =
      ValueIteration<Chain, measure>(chain, unknowns, {.tolerance = tolerance, .sweeps = sweeps, .on_grid = 0}).run();
  const auto solved = ValueIteration<MarkovChain, measure>(
                          written, same, {.tolerance = tolerance, .policy_iteration = true, .sweeps = sweeps})
                          .run();
  if (!found || !solved) return 0;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < written.states(); ++i) {
    const std::uint32_t o = written.origin(i);
    EXPECT_EQ(unknowns.unknown[o], same.unknown[i]) << what;
    EXPECT_LE(found->bounds.lower(o), solved->bounds.upper(i) * rounding) << what;
    EXPECT_GE(found->bounds.upper(o) * rounding, solved->bounds.lower(i)) << what;
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

struct Counts {
  std::size_t tried = 0, sooner = 0;
};

// With what is attained, times `wrong`, claimed of all states.
template <Measure measure>
void claim(const Product& product, const Strategy& strategy, const std::string& what, Counts& counts) {
  const Chain chain(product, strategy);
  const Unknowns unknowns = unknowns_of<measure>(chain);
  const IterationOptions limits{.tolerance = tolerance, .sweeps = sweeps, .on_grid = 0};
  const auto exact = ValueIteration<Chain, measure>(chain, unknowns, limits, {.attained = true}).run();
  if (!exact) return;
  for (double wrong : {0.5, 1.0, 2.0}) {
    std::pmr::vector<double> claimed = exact->attained;
    for (double& x : claimed) x = is_probability(measure) ? std::min(x * wrong, 1.0) : x * wrong;
    const auto found = ValueIteration<Chain, measure>(chain, unknowns, limits, {}, claimed).run();
    ASSERT_TRUE(found) << what;
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      const double lower = found->bounds.lower(i), upper = found->bounds.upper(i);
      EXPECT_LE(lower, exact->bounds.upper(i) * rounding) << what << "  claim " << wrong;
      EXPECT_GE(upper * rounding, exact->bounds.lower(i)) << what << "  claim " << wrong;
      EXPECT_LE(upper - lower, 4 * tolerance * (is_probability(measure) ? 1 : lower)) << what;
      counts.tried += unknowns.unknown[i] ? 1 : 0;
    }
    counts.sooner += wrong == 1.0 && found->sweeps < exact->sweeps ? 1 : 0;
  }
}

// What is claimed is where sweeps begin, no more: claims that are too great or too small change no value.
TEST(StrategyChain, TakesNoFalseClaims) {
  Counts chances, costs;
  for_each_strategy([&](const Product& product, const Strategy& strategy, const std::string& what) {
    claim<Measure::MaxProbability>(product, strategy, what, chances);
    claim<Measure::MinCost>(product, strategy, what, costs);
  });
  EXPECT_GT(chances.tried, 1000U);
  EXPECT_GT(chances.sooner, 20U);
  EXPECT_GT(costs.tried, 300U);
  EXPECT_GT(costs.sooner, 10U);
}

// Two halves of free ground and a bridge of one cell between hazards; the start is in one half, the goal in the other.
GridWorld bridge_grid(std::uint32_t side) {
  std::vector<GridCell> palette(4);
  palette[1].wall = true;
  palette[2].label = {ltl::Proposition{0}};
  palette[3].label = {ltl::Proposition{1}};
  const std::uint32_t first = (side - side / 5) / 2, last = first + side / 5, middle = side / 2;
  std::vector<std::uint16_t> cells(std::size_t{side} * side, 0);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = first; x < last && y != middle; ++x)
      cells[y * side + x] = y + 1 == middle || y == middle + 1 ? 3 : 1;
  cells[3 * side - 3] = 2;
  GridWorld::Shape shape{.width = side, .height = side};
  shape.motion.fill({.forward = 0.7, .left = 0.1, .right = 0.1, .back = 0.1});
  return GridWorld(shape, ltl::Vocabulary({"a", "x"}), palette, cells, middle * side + 2);
}

// What sweeps in place say of the best strategy, against the chain written out and solved.
TEST(StrategyChain, OfALongPassageIsWorthWhatTheChainWrittenOutIs) {
  constexpr std::uint32_t side = 50;
  const GridWorld grid = bridge_grid(side);
  const CaseAnswer found = answer(
      {"", grid, {}}, {.id = "", .formula = "!x U a", .query = CaseTask::Query::MaxProbability}, {.strategy = true});
  ASSERT_TRUE(found.strategy);
  ltl::Arena arena(grid.letters().vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("!x U a", arena));
  const TaskTable task(dfa, grid.letters());
  const auto product = Product::explore(grid, task);
  ASSERT_TRUE(product);
  std::vector<std::uint32_t> chosen(std::size_t{side} * side, 0);
  for (const Decision& d : found.strategy->decisions) chosen[d.state] = d.choice;
  Strategy strategy{Choices(product->states()), product->starts().front()};
  product->for_each_state([&](const auto& s) {
    if (!product->is_goal(s)) strategy.choice.set(s.index, chosen[s.place]);
  });
  const MarkovChain written(*product, strategy);
  const Unknowns unknowns = unknowns_of<Measure::MaxProbability>(written);
  const auto solved = ValueIteration<MarkovChain, Measure::MaxProbability>(
                          written, unknowns, {.tolerance = tolerance, .policy_iteration = true, .sweeps = 10'000})
                          .run();
  ASSERT_TRUE(solved);
  constexpr std::uint32_t start = 0;
  ASSERT_EQ(written.origin(start), product->starts().front());
  EXPECT_LE(found.strategy->re_evaluated.lower, solved->bounds.upper(start) * rounding);
  EXPECT_GE(found.strategy->re_evaluated.upper * rounding, solved->bounds.lower(start));
}

// What is kept of some states is what is kept of all.
TEST(StrategyChain, KeepsTheBoundsOfEntries) {
  std::size_t kept = 0, others = 0;
  for_each_strategy([&](const Product& product, const Strategy& strategy, const std::string& what) {
    const Chain chain(product, strategy);
    const Unknowns unknowns = unknowns_of<Measure::MaxProbability>(chain);
    const StateSet some = entries(chain, unknowns.unknown, product.starts());
    const IterationOptions limits{.tolerance = tolerance, .sweeps = sweeps, .on_grid = 0};
    const auto all = ValueIteration<Chain, Measure::MaxProbability>(chain, unknowns, limits).run();
    const auto found = ValueIteration<Chain, Measure::MaxProbability>(chain, unknowns, limits, {.bounds = &some}).run();
    ASSERT_EQ(all.has_value(), found.has_value()) << what;
    if (!all) return;
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      ++(some[i] ? kept : others);
      ASSERT_EQ(found->bounds.keeps(i), some[i]);
      if (!some[i]) continue;
      EXPECT_EQ(found->bounds.lower(i), all->bounds.lower(i)) << what;
      EXPECT_EQ(found->bounds.upper(i), all->bounds.upper(i)) << what;
    }
  });
  EXPECT_GT(kept, 150U);
  EXPECT_GT(others, kept);
}

TEST(Choices, WidenWhereABytesWorthIsNotEnough) {
  constexpr std::array<std::uint32_t, 7> made{0, 3, 254, 255, Choices::none, 256, 70'000};
  Choices choices(made.size());
  for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(choices[i], Choices::none);
  for (std::size_t i = 0; i < made.size(); ++i) {
    choices.set(i, made[i]);
    for (std::size_t j = 0; j <= i; ++j) EXPECT_EQ(choices[j], made[j]) << j << " of " << i;
  }
  choices.set(6, Choices::none);
  EXPECT_EQ(choices[6], Choices::none);
  EXPECT_EQ(choices.size(), made.size());
}

}  // namespace
}  // namespace waymark::plan
