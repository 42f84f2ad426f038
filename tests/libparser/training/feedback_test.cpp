#include "libparser/training/feedback.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libparser/language/generate.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

class FeedbackTest : public ::testing::Test {
 protected:
  FeedbackTest() {
    const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 2, .paragraphs = 12, .sentences = 3});
    examples = make_examples(corpus, executors, Convention::Absolute).sentences;
    for (std::size_t i = 0; i < examples.size(); i += 4) examples[i].gold.heading_unknown = true;
  }
  Feedback feedback(FeedbackKind kind) { return {executors, kind, Then::WholePlan, 1}; }

  std::vector<Executor> executors{shipped_maps().begin(), shipped_maps().end()};
  std::vector<Example> examples;
  PostfixGrammar grammar{shipped_maps().front().vocabulary()};
};

TEST_F(FeedbackTest, ProgressionIsTheShareOfTrajectoriesThatSatisfyTheFormula) {
  Feedback progression = feedback(FeedbackKind::Progression);
  std::mt19937_64 random(3);
  std::size_t partly = 0, wholly = 0;
  for (const Example& example : examples) {
    const plan::Map& map = executors[example.map].map();
    std::vector<plan::Trajectory> gold{*plan::follow(map, example.gold.start, example.gold.actions)};
    if (example.gold.heading_unknown) gold = trajectories_of(example.gold, map);
    for (int i = 0; i < 40; ++i) {
      const Program program = random_program(grammar, random);
      ltl::Arena arena(map.vocabulary());
      const ltl::Formula formula = formula_of(program, arena);
      double expected = 0;
      for (const plan::Trajectory& trajectory : gold) expected += ltl::holds(word_of(trajectory, map), formula) ? 1 : 0;
      expected /= static_cast<double>(gold.size());
      EXPECT_EQ(progression.of(program, example), expected) << grammar.show(program);
      wholly += expected == 1 ? 1 : 0;
      partly += expected > 0 && expected < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(wholly, 0U);
  EXPECT_GT(partly, 0U);
}

TEST_F(FeedbackTest, AnUnknownHeadingStandsForFour) {
  const plan::Map& map = shipped_maps().front();
  const GoldRoute gold{*map.find({1, 9, 0}), *map.find({1, 8, 0}), {plan::Action::Forward}, true};
  const auto all = trajectories_of(gold, map);
  ASSERT_EQ(all.size(), 4U);
  const std::size_t lengths[] = {1, 2, 3, 2};  // actions: from north, east, south, west
  for (std::size_t h = 0; h < 4; ++h) {
    EXPECT_EQ(map.pose(all[h].poses.front()).heading, static_cast<int>(90 * h));
    EXPECT_EQ(all[h].actions.size(), lengths[h]);
    EXPECT_EQ(all[h].poses.back(), gold.end);
  }
}

TEST_F(FeedbackTest, PlanComparesEnds) {
  Feedback plan = feedback(FeedbackKind::Plan);
  std::mt19937_64 random(6);
  for (const Example& example : examples)
    for (int i = 0; i < 20; ++i) {
      const Program program = random_program(grammar, random);
      const auto route = executors[example.map].run(program, example.gold.start);
      EXPECT_EQ(plan.of(program, example), route && route->end == example.gold.end ? 1 : 0);
    }
}

TEST_F(FeedbackTest, DiscriminatingAsksForTheWholeTrajectory) {
  Feedback progression = feedback(FeedbackKind::Progression), discriminating = feedback(FeedbackKind::Discriminating);
  std::mt19937_64 random(7);
  std::size_t refused = 0, kept = 0;
  for (const Example& example : examples) {
    const plan::Map& map = executors[example.map].map();
    for (int i = 0; i < 40; ++i) {
      const Program program = random_program(grammar, random);
      const double satisfied = progression.of(program, example), reward = discriminating.of(program, example);
      EXPECT_TRUE(reward == 0 || reward == satisfied);
      ltl::Arena arena(map.vocabulary());
      const ltl::Formula formula = formula_of(program, arena);
      plan::Trajectory prefix = *plan::follow(map, example.gold.start, example.gold.actions);
      while (!prefix.actions.empty()) {
        prefix.actions.pop_back();
        prefix.poses.pop_back();
        if (ltl::holds(word_of(prefix, map), formula)) {
          EXPECT_EQ(reward, 0) << grammar.show(program);
        }
      }
      refused += satisfied > 0 && reward == 0 ? 1 : 0;
      kept += reward > 0 ? 1 : 0;
    }
    const Program long_enough{{StepKind::Forward, 1, 0, {}}};
    kept += discriminating.of(long_enough, example) > 0 ? 1 : 0;
  }
  EXPECT_GT(refused, 0U);
  EXPECT_GT(kept, 0U);
}

}  // namespace
}  // namespace waymark::parser
