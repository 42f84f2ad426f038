#include "libplan/learn/hierarchical.hpp"

#include <gtest/gtest.h>

#include "libplan/learn/optimum.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t steps = 8'000;

PolicyValue learnt(const TabularProduct& product) {
  return learn(product, Hierarchical{}, {.steps = steps, .interval = steps, .horizon = 100})
      .checkpoints.back()
      .value;
}

// One goal after the other, each the nearest of its kind: there options are enough.
TEST(Hierarchical, IsOptimalWhereNearestGoalsAre) {
  for (const char* formula : {"F chair", "F (sofa & X F chair)", "F sofa & F chair"}) {
    const TabularProduct product = task_on(plus(), formula, PoseId{3});
    EXPECT_NEAR(learnt(product).value, optimum(product).value.value, 1e-12) << formula;
  }
}

// The way to the sofa that its option knows begins with a left turn; the task forbids it, and there is another way.
TEST(Hierarchical, OptionsPayNoRegardToWhatMustBeAvoided) {
  const Map map = square();
  const TabularProduct product = task_on(map, "F sofa & G !turned_left", pose_at(map, 0, 0, 180));
  EXPECT_EQ(optimum(product).value.cost, 5);
  EXPECT_EQ(learnt(product).probability, 0);
}

TEST(Hierarchical, ATaskWithoutPropositionsIsLearntToo) {
  const TabularProduct product = task_on(square(), "X X X true");
  EXPECT_EQ(learnt(product).cost, 3);
}

TEST(Hierarchical, TheSameSeedGivesTheSameCurve) {
  const TabularProduct product = task_on(plus(), "F (sofa & X F chair)", PoseId{3}, slippery);
  const Training training{.steps = 40'000, .interval = 4'000, .seed = 4};
  const LearningCurve one = learn(product, Hierarchical{}, training),
                      two = learn(product, Hierarchical{}, training);
  for (std::size_t i = 0; i < one.checkpoints.size(); ++i)
    EXPECT_EQ(one.checkpoints[i].value.value, two.checkpoints[i].value.value);
  EXPECT_GT(one.checkpoints.back().value.probability, 0.9);
}

}  // namespace
}  // namespace waymark::plan
