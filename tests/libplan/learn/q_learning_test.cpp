// Learners in tables: they come to what value iteration finds, and the variants change the way, not the end.
#include "libplan/learn/q_learning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libplan/learn/optimum.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

std::vector<std::pair<const char*, QLearning>> variants() {
  return {{"plain", {}},
          {"counterfactual", {.counterfactual = true}},
          {"shaped", {.shaped = true}},
          {"both", {.counterfactual = true, .shaped = true}},
          {"curriculum", {.counterfactual = true, .curriculum = true}},
          {"replay", {.replays = 4}},
          {"all", {.counterfactual = true, .shaped = true, .curriculum = true, .replays = 8}}};
}

TEST(QLearning, EveryVariantComesToTheOptimum) {
  for (const Map& map : {hallway(3), square(), plus()})
    for (const char* formula : {"F (chair & X F sofa)", "F sofa", "!sofa U blue", "F chair & F blue"}) {
      const TabularProduct product = task_on(map, formula, PoseId{2});
      const PolicyValue best = optimum(product).value;
      if (best.probability == 0 || product.is_over()) continue;
      for (const auto& [name, method] : variants()) {
        const QTable table = learn(product, method, {.steps = 6'000, .interval = 2'000, .horizon = 100});
        EXPECT_NEAR(table.curve.checkpoints.back().value.value, best.value, 1e-12)
            << name << "  " << map.name() << "  " << formula;
      }
    }
}

// Noise: values near those of value iteration, and a policy nearly as good.
TEST(QLearning, ComesNearTheOptimumOfANoisyModel) {
  const TabularProduct product = task_on(plus(), "F (sofa & X F chair)", PoseId{3}, slippery);
  const PolicyValue best = optimum(product).value;
  for (const auto& [name, method] : variants()) {
    const QTable table = learn(product, method, {.steps = 60'000, .interval = 60'000, .horizon = 200, .seed = 3});
    EXPECT_GT(table.curve.checkpoints.back().value.value, 0.97 * best.value) << name;
    if (method.shaped) continue;  // then the table holds Q − Φ
    const std::uint32_t start = product.starts[0].state;
    double learnt = 0;
    for (std::uint32_t a = 0; a < product.actions; ++a)
      learnt = std::max(learnt, table.values[std::size_t{start} * product.actions + a]);
    EXPECT_NEAR(learnt, best.value, 0.1) << name;
  }
}

// [NHR99, Th. 1]: with shaping the table holds Q − Φ, so what is best stays best.
TEST(QLearning, ShapingMovesValuesByThePotentialAndLeavesTheBestPolicy) {
  const TabularProduct product = task_on(plus(), "F (sofa & X F chair)", PoseId{3});
  const Training training{.steps = 60'000, .interval = 60'000, .horizon = 50, .explore = 1, .explore_last = 1};
  const QTable plain = learn(product, {.counterfactual = true}, training),
               shaped = learn(product, {.counterfactual = true, .shaped = true}, training);
  const std::vector<double> phi = potential(product.task, training.discount);
  std::size_t compared = 0;
  for (std::uint32_t state = 0; state < product.states(); ++state) {
    if (product.ending(state) != Ending::Open) continue;
    for (std::uint32_t a = 0; a < product.actions; ++a) {
      const std::size_t entry = std::size_t{state} * product.actions + a;
      if (!product.is_offered(product.position_of(state), a)) continue;
      EXPECT_NEAR(shaped.values[entry] + phi[product.task_of(state)], plain.values[entry], 1e-9) << state << ' ' << a;
      ++compared;
    }
  }
  EXPECT_GT(compared, 80U);
}

// The potential is an upper bound of every value: optimism is justified.
TEST(QLearning, ThePotentialIsOptimistic) {
  const TabularProduct product = task_on(shipped("grid"), "F (sofa & X F (chair & X F easel))", PoseId{5});
  const std::vector<double> phi = potential(product.task, 0.9);
  for (std::uint32_t q = 0; q < product.task.tasks; ++q) {
    if (product.task.ending[q] != Ending::Open) {
      EXPECT_EQ(phi[q], 0);
      continue;
    }
    for (std::uint32_t position = 0; position < product.positions; position += 7) {
      TabularProduct from = product;
      from.starts = {{product.state(position, q), 1}};
      EXPECT_LE(optimum(from).value.value, phi[q] + 1e-12);
    }
  }
}

// One counterfactual step is a step of every task of the automaton from the same position.
TEST(QLearning, CounterfactualExperienceIsThatOfTheProduct) {
  const Map map = shipped("jelly");
  const TabularProduct product = task_on(map, "F (sofa & X F (chair & X F easel))", PoseId{9});
  const Training training{.steps = 4'000, .interval = 4'000, .horizon = 4'000, .explore = 1, .explore_last = 1};
  const QTable table = learn(product, {.counterfactual = true}, training);
  std::size_t open = 0;
  for (const Ending ending : product.task.ending) open += ending == Ending::Open ? 1 : 0;
  EXPECT_EQ(table.curve.updates, 4'000 * open);
  // A value of 1 that was updated is a step into acceptance; one below it is bounded by the best step there is.
  for (std::uint32_t q = 0; q < product.task.tasks; ++q) {
    if (product.task.ending[q] != Ending::Open) continue;
    for (std::uint32_t position = 0; position < product.positions; ++position)
      for (std::uint32_t a = 0; a < product.actions; ++a) {
        if (!product.is_offered(position, a)) continue;
        const auto& o = product.outcomes_of(position, a)[0];
        const double value = table.values[std::size_t{product.state(position, q)} * product.actions + a];
        const bool accepts = product.task.ending[product.task.after(q, o.letter)] == Ending::Accepting;
        if (accepts)
          EXPECT_EQ(value, 1);
        else
          EXPECT_TRUE(value == 1 || value <= 0.9) << value;
      }
  }
}

TEST(QLearning, TheSameSeedGivesTheSameBytes) {
  const TabularProduct product = task_on(shipped("l"), "F (sofa & X F chair)", PoseId{7}, slippery);
  for (const auto& [name, method] : variants()) {
    const Training training{.steps = 3'000, .interval = 1'000, .seed = 5};
    const QTable one = learn(product, method, training), two = learn(product, method, training);
    EXPECT_EQ(one.values, two.values) << name;
    Training other = training;
    other.seed = 6;
    EXPECT_NE(one.values, learn(product, method, other).values) << name;
  }
}

TEST(QLearning, RefusesATaskThatIsOverAndStopsWhenAsked) {
  const Map map = hallway(2);
  EXPECT_THROW(learn(task_on(map, "F chair", pose_at(map, 2, 0, 0)), {}, {}), std::invalid_argument);
  std::stop_source source;
  source.request_stop();
  const QTable table = learn(task_on(map, "F chair"), {}, {.stop = source.get_token()});
  EXPECT_EQ(table.curve.checkpoints.back().steps, 0U);
}

}  // namespace
}  // namespace waymark::plan
