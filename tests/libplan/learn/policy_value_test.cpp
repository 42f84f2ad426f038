// Values of policies: against chains solved by hand, against rollouts, and the optimum against every policy.
#include "libplan/learn/policy_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libplan/learn/environment.hpp"
#include "libplan/learn/optimum.hpp"
#include "libplan/solve/route_planner.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

// 0 stays with 1/2, else to 1 (accepting, 3/8) or 2 (trap, 1/8); each step costs 2.
PolicyChain coin() {
  return {{0, 3, 3, 3},
          {{0, 0.5}, {1, 0.375}, {2, 0.125}},
          {2, 0, 0},
          {Ending::Open, Ending::Accepting, Ending::Trap},
          {{0, 1}}};
}

TEST(PolicyValue, SolvedByHand) {
  const PolicyValue value = value_of(coin(), 0.9);
  EXPECT_NEAR(value.probability, 0.75, 1e-12);
  EXPECT_NEAR(value.cost, 4, 1e-12);                         // two steps in the mean, however it ends
  EXPECT_NEAR(value.value, 0.375 / (1 - 0.9 * 0.5), 1e-12);  // v = 3/8 + γ v / 2
}

TEST(PolicyValue, StartsAreAveraged) {
  PolicyChain chain = coin();
  chain.starts = {{0, 0.5}, {1, 0.25}, {2, 0.25}};
  const PolicyValue value = value_of(chain, 0.9);
  EXPECT_NEAR(value.probability, 0.5 * 0.75 + 0.25, 1e-12);
  EXPECT_NEAR(value.cost, 0.5 * 0.75 * 4 / 0.625, 1e-12);
}

TEST(PolicyValue, PathsAndCircles) {
  PolicyChain path{
      {0, 1, 2, 2}, {{1, 1}, {2, 1}}, {1, 5, 0}, {Ending::Open, Ending::Open, Ending::Accepting}, {{0, 1}}};
  const PolicyValue value = value_of(path, 0.5);
  EXPECT_EQ(value.probability, 1);
  EXPECT_EQ(value.cost, 6);
  EXPECT_EQ(value.value, 0.5);
  path.outcomes[1].target = 0;
  EXPECT_EQ(value_of(path, 0.5).probability, 0);
  EXPECT_TRUE(std::isinf(value_of(path, 0.5).cost));
}

TEST(PolicyValue, AgreesWithRollouts) {
  const Map map = plus();
  const TabularProduct product = task_on(map, "F (sofa & X F chair) & G !place_1", pose_at(map, 1, 2, 0), slippery);
  const ActionTable policy = optimum(product).policy;
  const PolicyValue value = value_of(product, policy, 0.9);
  EXPECT_GT(value.probability, 0.05);
  EXPECT_LT(value.probability, 0.95);
  ltl::Random random(9);
  Environment environment(product, 100'000, random);
  constexpr int episodes = 40'000;
  double accepted = 0, cost = 0, discounted = 0;
  for (int i = 0; i < episodes; ++i) {
    environment.reset();
    double steps = 0;
    Environment::Transition step;
    do {
      step = environment.step(policy[environment.state()]);
      ++steps;
    } while (!step.is_last());
    if (step.ending != Ending::Accepting) continue;
    ++accepted;
    cost += steps;
    discounted += std::pow(0.9, steps - 1);
  }
  EXPECT_NEAR(value.probability, accepted / episodes, 0.01);
  EXPECT_NEAR(value.cost, cost / accepted, 0.2);
  EXPECT_NEAR(value.value, discounted / episodes, 0.01);
}

TEST(Optimum, IsTheLeastCostWhereNothingSlips) {
  for (const char* name : {"grid", "jelly", "l"}) {
    const Map map = shipped(name);
    for (const char* formula : {"F (sofa & X F (chair & X F easel))", "!blue U lamp", "F place_3 & F place_1"}) {
      const automata::Dfa dfa = dfa_of(formula);
      for (std::uint32_t i = 0; i < map.poses(); i += 29) {
        const auto planned = RoutePlanner(map, dfa).plan(PoseId{i});
        const PolicyValue best = optimum(tabulate(map, dfa, PoseId{i})).value;
        if (const auto* route = std::get_if<Route>(&planned))
          EXPECT_EQ(best.cost, route->cost) << name << "  " << formula << "  " << show(map.pose(PoseId{i}));
        else
          EXPECT_EQ(best.probability, 0) << name << "  " << formula << "  " << show(map.pose(PoseId{i}));
      }
    }
  }
}

// No change of one action, anywhere, makes the policy better.
TEST(Optimum, NoSingleActionImprovesIt) {
  const Map map = plus();
  const TabularProduct product = task_on(map, "F (sofa & X F chair)", PoseId{0}, slippery);
  const Optimum best = optimum(product);
  for (std::uint32_t state = 0; state < product.states(); ++state) {
    if (best.policy[state] == no_action) continue;
    ActionTable other = best.policy;
    for (std::uint8_t a = 0; a < product.actions; ++a) {
      if (!product.is_offered(product.position_of(state), a)) continue;
      other[state] = a;
      EXPECT_LE(value_of(product, other, 0.9).value, best.value.value + 1e-11);
    }
  }
}

}  // namespace
}  // namespace waymark::plan
