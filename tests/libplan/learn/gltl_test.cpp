// Tasks whose operators expire: against probabilities worked out by hand, and without expiry against the automaton.
#include "libplan/learn/gltl.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libltl/text/parse.hpp"
#include "libplan/learn/comparison.hpp"
#include "libplan/learn/optimum.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

struct Task {
  Task(const Map& map, const std::string& text, PoseId start, double keep) {
    ltl::Arena arena(map.vocabulary());
    const Mdp model = mdp_of(map, start);
    const TaskRows table = gltl_tasks(ltl::parse(text, arena), model.letters(), {.keep = keep}).value();
    expiring = compose(model, table);
    lasting = compose(model, without_expiry(table));
  }
  double best() const { return optimum(expiring, {.discount = 1}).value.probability; }
  TabularProduct expiring, lasting;
};

// Three letters do not carry the goal, the fourth does: F must survive three tosses.
TEST(Gltl, EventuallyIsDiscountedByTheWay) {
  const Map map = hallway(3);
  const PoseId start = pose_at(map, 0, 0, 90);
  EXPECT_NEAR(Task(map, "F chair", start, 0.9).best(), std::pow(0.9, 3), 1e-9);
  // The outer F survives the three tosses; the inner one is read first at the chair, then lives through its own.
  EXPECT_NEAR(Task(map, "F (chair & X F turned_left)", start, 0.9).best(), std::pow(0.9, 3), 1e-9);
}

// G p holds with each letter until it expires, and then for good: from a place where p holds for ever that is certain;
// where one p-letter is all there is, the first toss must do it.
TEST(Gltl, AlwaysCanBeFulfilled) {
  const Map map = hallway(3);
  const PoseId start = pose_at(map, 0, 0, 90);
  EXPECT_NEAR(Task(map, "G !chair", start, 0.9).best(), 1, 1e-6);
  EXPECT_NEAR(Task(map, "G !moved & X moved", start, 0.9).best(), 0.1, 1e-9);
}

TEST(Gltl, NextDoesNotExpire) {
  const Map map = hallway(3);
  EXPECT_NEAR(Task(map, "X X X chair", pose_at(map, 0, 0, 90), 0.5).best(), 1, 1e-12);
}

// Of a co-safe task nothing but the reward changes: without expiry its states accept where the automaton does.
TEST(Gltl, WithoutExpiryItIsTheAutomaton) {
  const Map map = plus();
  for (const char* formula :
       {"F (sofa & X F chair)", "F sofa & F chair", "!blue U (turned_left & X moved)"}) {
    const PoseId start = pose_at(map, 1, 2, 0);
    const PolicyValue expected = optimum(task_on(map, formula, start)).value;
    const PolicyValue lasting = optimum(Task(map, formula, start, 0.9).lasting).value;
    EXPECT_EQ(lasting.cost, expected.cost) << formula;
    EXPECT_EQ(lasting.probability, expected.probability) << formula;
  }
}

TEST(Gltl, ALearnerRewardedByItFindsTheRoute) {
  const Map map = plus();
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula phi = ltl::parse("F (sofa & X F chair)", arena);
  const PoseId start = pose_at(map, 1, 2, 0);
  const LearningTask task(map, automata::ltlf_to_dfa(phi), phi, {&start, 1}, {.gltl = true});
  const std::vector<Method> methods = learning_methods();
  const auto gltl =
      std::find_if(methods.begin(), methods.end(), [](const Method& m) { return m.name == "gltl"; });
  ASSERT_TRUE(task.allows(*gltl));
  const LearningCurve curve = task.run(*gltl, {.steps = 20'000, .interval = 20'000, .horizon = 200});
  EXPECT_GT(score(curve.checkpoints.back().value, task.optimum().value), 0.8);
}

TEST(Gltl, RefusesFormulasWithTooManyOperators) {
  const Map map = plus();
  ltl::Arena arena(map.vocabulary());
  const Mdp model = mdp_of(map, PoseId{0});
  EXPECT_FALSE(gltl_tasks(ltl::parse("F sofa & F chair", arena), model.letters(), {.most_coins = 1}));
  EXPECT_FALSE(gltl_tasks(ltl::parse("F sofa & F chair", arena), model.letters(), {.most_states = 2}));
}

}  // namespace
}  // namespace waymark::plan
