#include "libparser/programs/execute.hpp"

#include <gtest/gtest.h>

#include "libltl/text/print.hpp"
#include "libplan/plan_of.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

// The law: the executor's plan is the route that libplan finds for the program's formula, action by action.
void expect_same_plan(const Executor& executor, const PostfixGrammar& grammar, const Program& program,
                      plan::PoseId start) {
  const plan::Map& map = executor.map();
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula formula = formula_of(program, arena);
  const plan::Planned planned = plan::plan_of(map, formula, start, {.explain = false});
  const auto plan = executor.run(program, start);
  const plan::Pose p = map.pose(start);
  const std::string where = grammar.show(program) + "  =  " + ltl::print(formula) + "  on " + map.name() + " from " +
                            std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.heading);
  const auto* const route = std::get_if<plan::CertifiedRoute>(&planned);
  ASSERT_EQ(plan.has_value(), route != nullptr) << where;
  if (route == nullptr) return;
  EXPECT_EQ(plan->actions, route->route().actions) << where;
  EXPECT_EQ(plan->end, route->route().poses.back()) << where;
}

class ExecuteIn : public ::testing::TestWithParam<PostfixGrammar::Limits> {};

TEST_P(ExecuteIn, PlansRandomProgramsAsTheSolverDoes) {
  std::mt19937_64 random(7);
  for (const plan::Map& map : shipped_maps()) {
    const Executor executor(map);
    const PostfixGrammar grammar(map.vocabulary(), GetParam());
    for (int i = 0; i < 300; ++i) {  // the automata of three nested functions take seconds
      const Program program = random_program(grammar, random);
      const plan::PoseId start{static_cast<std::uint32_t>(random() % map.poses())};
      expect_same_plan(executor, grammar, program, start);
      if (HasFatalFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, ExecuteIn,
                         ::testing::Values(PostfixGrammar::limits_of(Dialect::Plain),
                                           PostfixGrammar::Limits{3, 2, Dialect::Temporal}),
                         [](const auto& parameter) {
                           return parameter.param.dialect == Dialect::Plain ? "Plain" : "Temporal";
                         });

// From every pose, for the functions of steps and the steps that the temporal dialect adds.
TEST(Execute, PlansWhatTheTemporalDialectAddsAsTheSolverDoes) {
  const plan::Map& map = shipped_maps().front();
  const Executor executor(map);
  const PostfixGrammar grammar(map.vocabulary(), Dialect::Temporal);
  const auto literal = [&](const char* name) {
    return static_cast<std::uint16_t>(map.vocabulary().find(name).value().index);
  };
  const auto step = [&](StepKind kind, const char* name, std::uint8_t count = 0) {
    return Step{kind, count, 1, {literal(name)}};
  };
  const Step to_easel = step(StepKind::Reach, "easel"), left = step(StepKind::Next, "turned_left"),
             two{StepKind::Forward, 2, 0, {}};
  const Program table[] = {
      {step(StepKind::Past, "chair"), to_easel},
      {step(StepKind::Advance, "intersection", 2)},
      {step(StepKind::Advance, "intersection", 3), left},
      {step(StepKind::Without, "intersection"), to_easel, left},
      {step(StepKind::Keep, "corridor"), to_easel},
      {step(StepKind::Keep, "ahead_open"), two},
      {step(StepKind::Without, "chair"), step(StepKind::Past, "lamp")},
      {step(StepKind::When, "ahead_wall"), left, two},
      {two, step(StepKind::Whether, "left_wall"), left, to_easel, left},
  };
  for (const Program& program : table)
    for (std::uint32_t s = 0; s < map.poses(); s += 5) {
      expect_same_plan(executor, grammar, program, {s});
      if (HasFatalFailure()) return;
    }
}

TEST(Execute, PlansOneLiteralStepsFromEveryPoseAsTheSolverDoes) {
  const plan::Map& map = shipped_maps().front();
  const Executor executor(map);
  const PostfixGrammar grammar(map.vocabulary());
  for (const char* literal : {"chair", "ahead_wall", "turned_left", "left_blue", "intersection"})
    for (StepKind kind : {StepKind::Reach, StepKind::Next, StepKind::Advance, StepKind::Face})
      for (std::uint32_t s = 0; s < map.poses(); s += 3) {
        const auto p = static_cast<std::uint16_t>(map.vocabulary().find(literal).value().index);
        expect_same_plan(executor, grammar, {{kind, 0, 1, {p}}}, {s});
        if (HasFatalFailure()) return;
      }
}

TEST(Execute, HorizonsListArrivalsInTheOrderOfTheirPlans) {
  const plan::Map& map = shipped_maps()[1];
  const Executor executor(map);
  for (StepKind kind : {StepKind::Reach, StepKind::Next, StepKind::Advance, StepKind::Face}) {
    for (std::uint32_t s = 0; s < map.poses(); s += 7) {
      const auto horizon = executor.horizon(kind, {s});
      for (std::size_t i = 0; i < executor.propositions(); ++i) {
        const auto p = static_cast<std::uint16_t>(i);
        const auto first = std::find_if(horizon.begin(), horizon.end(), [&](const auto& r) {
          return r.goal && executor.holds(p, r.arrival) && !r.arrival.is_start();
        });
        const auto at_start = kind == StepKind::Reach && executor.holds(p, Arrival::start({s}));
        const auto plan = executor.run({{kind, 0, 1, {p}}}, {s});
        if (at_start) {
          EXPECT_EQ(plan->end, plan::PoseId{s});
        } else if (first == horizon.end()) {
          EXPECT_FALSE(plan.has_value());
        } else {
          EXPECT_EQ(plan->end, first->arrival.pose());
        }
      }
    }
  }
}

TEST(Execute, StepwiseAndWholePlansDifferWhereGreedIsPunished) {
  const plan::Map& map = shipped_maps().front();
  const Executor executor(map);
  const PostfixGrammar grammar(map.vocabulary(), PostfixGrammar::Limits{3, 2, Dialect::Temporal});
  std::mt19937_64 random(3);
  std::size_t longer = 0, both = 0;
  for (int i = 0; i < 8000; ++i) {
    const Program program = random_program(grammar, random);
    const plan::PoseId start{static_cast<std::uint32_t>(random() % map.poses())};
    const auto whole = executor.run(program, start), steps = executor.run(program, start, Then::Stepwise);
    if (!steps) continue;
    ASSERT_TRUE(whole.has_value()) << grammar.show(program);
    ++both;
    EXPECT_LE(whole->actions.size(), steps->actions.size()) << grammar.show(program);
    if (whole->actions.size() < steps->actions.size()) ++longer;
  }
  EXPECT_GT(both, 500U);
  EXPECT_GT(longer, 0U);
}

TEST(Execute, ProgramsOfManyStepsAreCarriedOutOrRefused) {
  const Executor executor(shipped_maps().front());
  const auto forwards = [](std::size_t n) { return Program(n, Step{StepKind::Next, 0, 1, {0}}); };
  EXPECT_NO_THROW(executor.run(forwards(100), {0}));
  EXPECT_THROW(executor.run(forwards(1025), {0}), std::length_error);
}

}  // namespace
}  // namespace waymark::parser
