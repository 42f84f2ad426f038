#include "libparser/experiment/learned/learned_follower.hpp"

#include <gtest/gtest.h>

#include "libltl/text/print.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

// Reads one program in whatever it is told.
class OneProgram : public Follower {
 public:
  explicit OneProgram(Program program) : program_(std::move(program)) {}
  Response follow(const Executor& executor, const SentenceInput&, plan::PoseId start) const override {
    const auto plan = executor.run(program_, start);
    return {plan->end, plan->actions, program_, 1};
  }

 private:
  Program program_;
};

Step goal(StepKind kind, const std::string& proposition) {
  return {kind, 0, 1, {static_cast<std::uint16_t>(shipped_maps()[0].vocabulary().find(proposition)->index)}};
}

// Short tasks are learned: from every start they are done, in as few steps as the exact plan takes.
TEST(LearnedFollower, ShortTasksComeToTheExactPlan) {
  const Executor executor(shipped_maps()[0]);
  const plan::Map& map = executor.map();
  const std::vector<Program> programs{{goal(StepKind::Next, "turned_left")},
                                      {goal(StepKind::Next, "turned_right"), {StepKind::Forward, 1, 0, {}}},
                                      {{StepKind::Forward, 2, 0, {}}}};
  int asked = 0;
  for (const Program& program : programs)
    for (std::uint32_t s = 0; s < map.poses(); s += testing::sanitized ? 111 : 37) {
      const plan::PoseId start{s};
      if (!executor.run(program, start)) continue;
      const auto exact = std::make_shared<const OneProgram>(program);
      const LearnedFollower learned(exact, {.steps = 3'000});
      const Response want = exact->follow(executor, {}, start), got = learned.follow(executor, {}, start);
      ltl::Arena arena(map.vocabulary());
      EXPECT_EQ(got.end, want.end) << ltl::print(formula_of(program, arena)) << " from pose " << s;
      EXPECT_EQ(got.actions.size(), want.actions.size());
      EXPECT_EQ(learned.follow(executor, {}, start).actions, got.actions);
      ++asked;
    }
  EXPECT_GE(asked, testing::sanitized ? 2 : 6);
}

TEST(LearnedFollower, WhatIsNotReadIsNotLearned) {
  const Executor executor(shipped_maps()[0]);
  const LearnedFollower learned(std::make_shared<const StayingFollower>(), {});
  const Response answer = learned.follow(executor, {}, plan::PoseId{4});
  EXPECT_EQ(answer.end, plan::PoseId{4});
  EXPECT_TRUE(answer.actions.empty());
}

}  // namespace
}  // namespace waymark::parser
