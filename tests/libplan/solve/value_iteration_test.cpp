// Values of small products, block by block, against those of every policy; and one state by its definition.
#include "libplan/solve/value_iteration.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/libplan/solve/every_policy.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using testing::SmallProduct;

constexpr double tolerance = 1e-6, rounding = 1e-12;

// Written out and swept, by policies, state by state.
constexpr std::array<const char*, 3> ways{"sweeps", "policies", "states"};
IterationOptions options_of(std::size_t way) {
  IterationOptions out{.tolerance = tolerance, .policy_iteration = way == 1};
  if (way == 2) out.written_out = 0;
  return out;
}

// What is known by the graph, from the truth.
template <Measure measure>
Unknowns unknowns_of(const SmallProduct& product, const StateSet& targets, const testing::PolicyValues& truth) {
  Unknowns out{StateSet(product.states()), targets, {}};
  for (std::uint32_t i = 0; i < product.states(); ++i) {
    if (measure == Measure::MaxProbability) out.targets.set(i, truth.chance[i] > 1 - 1e-9);
    const bool some = measure == Measure::MaxProbability ? truth.chance[i] > 1e-9 : !std::isinf(truth.cost[i]);
    out.unknown.set(i, some && !out.targets[i]);
  }
  out.merged = end_components(product, out.unknown, [&](const auto& s, std::uint32_t k) {
    return measure == Measure::MaxProbability || product.cost(s, k) == 0;
  });
  return out;
}

struct Met {
  int unknown = 0, merged = 0;
};

template <Measure measure>
void expect_values(ltl::Random& random, int trial, Met& met) {
  const SmallProduct product = testing::small_product(random, static_cast<std::uint32_t>(3 + random.below(4)));
  const StateSet targets = testing::random_states(random, product.states(), 4);
  const testing::PolicyValues truth = testing::best_values(product, targets);
  const Unknowns unknowns = unknowns_of<measure>(product, targets, truth);
  const StateSet kept = entries(product, unknowns.unknown, {product.states() - 1});
  for (std::size_t way = 0; way < ways.size(); ++way)
    for (const bool all : {true, false}) {
      const std::string what =
          "trial " + std::to_string(trial) + ", by " + ways[way] + "\n" + testing::show(product) + "state ";
      const IterationOptions options = options_of(way);
      const Keep keep{.bounds = all ? nullptr : &kept, .attained = all};
      const auto found = ValueIteration<SmallProduct, measure>(product, unknowns, options, keep).run();
      ASSERT_TRUE(found) << what;
      ASSERT_EQ(found->attained.size(), all ? product.states() : 0U);
      for (std::uint32_t i = 0; i < product.states(); ++i) {
        ASSERT_EQ(found->bounds.keeps(i), all || kept[i]) << what << i;
        if (!found->bounds.keeps(i) || (!unknowns.unknown[i] && !unknowns.targets[i])) continue;
        const double value = is_probability(measure) ? truth.chance[i] : truth.cost[i];
        const double lower = found->bounds.lower(i), upper = found->bounds.upper(i);
        ASSERT_LE(lower, value * (1 + rounding) + rounding) << what << i;
        ASSERT_GE(upper, value * (1 - rounding) - rounding) << what << i;
        ASSERT_LE(upper - lower, tolerance * (is_probability(measure) ? 1 : value) * (1 + 1e-9) + rounding)
            << what << i;
        const double attained = is_probability(measure) ? lower : upper;
        ASSERT_EQ(all ? found->attained[i] : attained, attained) << what << i;
        met.unknown += unknowns.unknown[i] ? 1 : 0;
        met.merged += unknowns.merged.of[i] != EndComponents::none ? 1 : 0;
      }
    }
}

TEST(ValueIteration, GreatestProbabilitiesAreThoseOfTheBestPolicy) {
  ltl::Random random(108);
  Met met;
  for (int trial = 0; trial < waymark::testing::scaled(2'000) && !HasFatalFailure(); ++trial)
    expect_values<Measure::MaxProbability>(random, trial, met);
  EXPECT_GT(met.unknown, waymark::testing::scaled(1'500));
  EXPECT_GT(met.merged, waymark::testing::scaled(200));
}

TEST(ValueIteration, LeastCostsAreThoseOfTheBestPolicy) {
  ltl::Random random(109);
  Met met;
  for (int trial = 0; trial < waymark::testing::scaled(2'000) && !HasFatalFailure(); ++trial)
    expect_values<Measure::MinCost>(random, trial, met);
  EXPECT_GT(met.unknown, waymark::testing::scaled(1'500));
  EXPECT_GT(met.merged, waymark::testing::scaled(50));
}

// Two states that hardly lead to each other: a second sweep would do.
TEST(ValueIteration, EndsAfterAsManySweepsAsItIsGiven) {
  SmallProduct product;
  product.of = {{{.cost = 1, .outcomes = {{0, 1}}}},
                {{.cost = 1, .outcomes = {{2, 0.01}, {0, 0.49}, {SmallProduct::trap, 0.5}}}},
                {{.cost = 1, .outcomes = {{1, 0.01}, {0, 0.49}, {SmallProduct::trap, 0.5}}}}};
  product.ranges = {0, 1, 3};
  StateSet targets(3);
  targets.insert(0);
  const Unknowns unknowns =
      unknowns_of<Measure::MaxProbability>(product, targets, testing::best_values(product, targets));
  const auto found = [&](std::uint64_t sweeps) {
    IterationOptions options = options_of(2);
    options.sweeps = sweeps;
    return ValueIteration<SmallProduct, Measure::MaxProbability>(product, unknowns, options).run();
  };
  EXPECT_TRUE(found(10));
  EXPECT_FALSE(found(1));
}

// The best of what the choices come to: one that stays is taken again and again.
template <Measure measure>
double by_definition(const SmallProduct& product, const Unknowns& unknowns, std::uint32_t i,
                     const std::vector<double>& values) {
  const bool chance = is_probability(measure);
  double best = chance ? 0 : INFINITY;
  for (const SmallProduct::Choice& choice : product.of[i]) {
    double sum = chance ? 0 : choice.cost, stays = 0;
    bool counts = true;
    for (const SmallProduct::Outcome& o : choice.outcomes) {
      const bool known = o.target != SmallProduct::trap && (unknowns.unknown[o.target] || unknowns.targets[o.target]);
      const std::uint32_t own = unknowns.merged.of[i];
      if (o.target == i ||
          (own != EndComponents::none && o.target != SmallProduct::trap && unknowns.merged.of[o.target] == own))
        stays += o.probability;
      else if (o.target != SmallProduct::trap && (known || chance))
        sum += o.probability * values[o.target];
      else
        counts = counts && chance;
    }
    if (!counts || stays == 1) continue;
    double value = 0;
    for (int times = 0; times < 500; ++times) value = sum + stays * value;
    best = chance ? std::max(best, value) : std::min(best, value);
  }
  return best;
}

template <Measure measure>
void expect_operator(std::uint64_t seed) {
  ltl::Random random(seed);
  int merged = 0;
  for (int trial = 0; trial < waymark::testing::scaled(2'000); ++trial) {
    const SmallProduct product = testing::small_product(random, static_cast<std::uint32_t>(3 + random.below(4)));
    const StateSet targets = testing::random_states(random, product.states(), 4);
    const Unknowns unknowns = unknowns_of<measure>(product, targets, testing::best_values(product, targets));
    const EndComponentQuotient<SmallProduct> quotient(product, unknowns);
    const BellmanOperator<SmallProduct, measure> best(product, unknowns, quotient);
    std::vector<double> values(product.states());
    for (double& value : values) value = random.unit();
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      const std::uint32_t own = unknowns.merged.of[i];
      const double expected = by_definition<measure>(product, unknowns, i, values);
      const auto near = [](double a, double b) { return a == b || std::abs(a - b) < 1e-9; };
      ASSERT_PRED2(near, best.of({i}, values), expected) << "trial " << trial << ", state " << i << "\n"
                                                         << testing::show(product);
      double of_all = expected;
      for (std::uint32_t j = 0; j < product.states(); ++j) {
        if (own == EndComponents::none || unknowns.merged.of[j] != own) continue;
        const double other = by_definition<measure>(product, unknowns, j, values);
        of_all = is_probability(measure) ? std::max(of_all, other) : std::min(of_all, other);
        merged += j == i ? 0 : 1;
      }
      ASSERT_PRED2(near, best.of_all({i}, values), of_all) << "trial " << trial << ", state " << i << "\n"
                                                           << testing::show(product);
    }
  }
  EXPECT_GT(merged, waymark::testing::scaled(20));
}

TEST(BellmanOperator, IsTheBestOfTheChoices) {
  expect_operator<Measure::MaxProbability>(110);
  expect_operator<Measure::MinCost>(111);
}

// Chances that add up to 1 come to a little more in doubles: it is never left all the same.
TEST(BellmanOperator, AChoiceThatNeverLeavesIsNone) {
  SmallProduct product;
  product.of = {{{1, {{0, 0.05}, {0, 0.55}, {0, 0.3}, {0, 0.1}}}, {7, {{1, 1}}}}, {}};
  product.ranges = {0, 2};
  ASSERT_GT(0.05 + 0.55 + 0.3 + 0.1, 1);
  Unknowns unknowns{StateSet(2), StateSet(2), {}};
  unknowns.unknown.insert(0);
  unknowns.targets.insert(1);
  const EndComponentQuotient<SmallProduct> quotient(product, unknowns);
  const BellmanOperator<SmallProduct, Measure::MinCost> best(product, unknowns, quotient);
  for (const double value : {0.0, 3.0, 7.0}) EXPECT_EQ(best.of({0}, {value, 0}), 7) << value;
}

}  // namespace
}  // namespace waymark::plan
