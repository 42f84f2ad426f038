#include "libplan/learn/dqn.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libltl/text/parse.hpp"
#include "libplan/learn/observations.hpp"
#include "libplan/learn/optimum.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

struct Small {  // a task of a few dozen states, with everything a network may be shown
  explicit Small(const std::string& text, const SlipChances& slip = {}) : map(plus()), arena(map.vocabulary()) {
    const ltl::Formula phi = ltl::parse(text, arena);
    product = tabulate(map, automata::ltlf_to_dfa(phi), PoseId{3}, slip);
    trees = trees_of(product.task, phi);
    seen = observe(map, Sight::Landmarks);
  }
  Map map;
  ltl::Arena arena;
  TabularProduct product;
  TaskTrees trees;
  Observations seen;
};

Training training(std::size_t steps) {
  return {.steps = steps,
          .interval = steps / 20,
          .horizon = 50,
          .explore = 1,
          .explore_last = 0.1,
          .explore_steps = steps / 2,
          .seed = 2};
}

// The best of the checkpoints: a network goes on moving, and the last one depends on the last bits of its floats.
double best_of(const LearningCurve& curve) {
  double best = 0;
  for (const Checkpoint& checkpoint : curve.checkpoints) best = std::max(best, checkpoint.value.value);
  return best;
}

TEST(Dqn, LearnsASmallTaskInEveryVariant) {
  const Small small("F (sofa & X F chair)");
  const double best = optimum(small.product).value.value;
  const Dqn fast{.hidden = {32, 32}, .rate = 1e-3};
  Dqn twice = fast, ranked = fast;
  twice.double_q = true;
  ranked.prioritised = true;
  const std::vector<std::tuple<const char*, Dqn, const TaskTrees*>> variants{{"one-hot", fast, nullptr},
                                                                             {"double", twice, nullptr},
                                                                             {"prioritised", ranked, nullptr},
                                                                             {"trees", fast, &small.trees}};
  for (const auto& [name, method, trees] : variants) {
    const LearningCurve curve = learn(small.product, {&small.seen.by_position, trees}, method, training(6'000));
    EXPECT_NEAR(best_of(curve), best, 1e-9) << name;
    EXPECT_EQ(curve.updates, 6'000 - method.batch + 1) << name;
  }
}

TEST(Dqn, LearnsANoisyTask) {
  const Small small("F sofa", slippery);
  const double best = optimum(small.product).value.value;
  const LearningCurve curve =
      learn(small.product, {&small.seen.by_position, nullptr}, {.hidden = {32, 32}, .rate = 1e-3}, training(6'000));
  EXPECT_GT(best_of(curve), 0.9 * best);
}

TEST(Dqn, TheSameSeedGivesTheSameCurve) {
  const Small small("F (sofa & X F chair)");
  Training often = training(1'000);
  often.interval = 50;
  const DqnInput input{&small.seen.by_position, nullptr};
  const LearningCurve one = learn(small.product, input, {}, often), two = learn(small.product, input, {}, often);
  ASSERT_EQ(one.checkpoints.size(), 21U);
  for (std::size_t i = 0; i < one.checkpoints.size(); ++i)
    EXPECT_EQ(one.checkpoints[i].value.value, two.checkpoints[i].value.value) << i;
}

TEST(Dqn, RefusesObservationsOfAnotherMap) {
  const Small small("F sofa");
  const Observations other = observe(square(), Sight::Objects);
  EXPECT_THROW(learn(small.product, {&other.by_position, nullptr}, {}, training(10)), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
