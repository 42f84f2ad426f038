// What is answered of planning cases: which values are answers, of which routes, to which questions.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "libplan/solve/case_task.hpp"
#include "tests/libplan/solve/random_models.hpp"

namespace waymark::plan {
namespace {

// A corridor of five cells, hazard in the middle of the upper row; `motion`: of the robot, or nothing.
PlanningCase corridor_of(const std::string& motion) {
  return parse_case(R"({"format": "ltlgrid/1", "name": "corridor", "width": 5, "height": 2,
    "rows": ["..x.a", "s...b"], "legend": {"x": {"props": ["x"]}, "a": {"props": ["a"]}, "b": {"props": ["b"]},
    "s": {}}, "start": {"x": 0, "y": 1})" +
                    motion + "}");
}
PlanningCase plain_corridor() { return corridor_of(""); }

CaseAnswer noisy_answer(const std::string& formula, CaseTask::Query query) {
  const PlanningCase noisy = corridor_of(R"(, "motion": {"forward": 0.8, "left": 0.1, "right": 0.1, "back": 0})");
  return answer(noisy, {.id = "", .formula = formula, .query = query});
}

// There and back between two places that both show `a`: every step is a round of its own.
TEST(CaseAnswer, AMeanIsThatOfTheRoundsOfACycle) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId a = builder.letter({ltl::Proposition{0}});
  for (std::uint32_t s = 0; s < 2; ++s) {
    builder.add_state();
    builder.add_choice("go", 1);
    builder.add_outcome(1 - s, a);
  }
  const PlanningCase pair{"", std::move(builder).build(0, a), {}};
  const CaseTask lasso{.id = "", .formula = "G F a", .query = CaseTask::Query::LeastLasso};
  const auto value = [&](LassoOrder order) { return answer(pair, lasso, {.order = order}).value.upper; };
  EXPECT_EQ(value(LassoOrder::Cycle), 2);
  EXPECT_EQ(value(LassoOrder::Mean), 1);
}

// Every cell is met before the far corner, each on several walks: the limit is one of pairs.
TEST(CaseAnswer, ASearchForOneRouteMeetsPairsOnce) {
  std::string rows = '"' + std::string(39, '.') + "a\"";
  for (int y = 1; y < 50; ++y) rows += ", \"" + std::string(40, '.') + '"';
  const PlanningCase open = parse_case(R"({"format": "ltlgrid/1", "width": 40, "height": 50, "rows": [)" + rows +
                                       R"(], "legend": {"a": {"props": ["a"]}}, "start": {"x": 0, "y": 49}})");
  const CaseTask task{.id = "", .formula = "F a", .query = CaseTask::Query::MinCost};
  const CaseAnswer found = answer(open, task, {.states = 2'100});
  EXPECT_EQ(found.status, CaseAnswer::Status::Solved) << found.reason;
  EXPECT_EQ(found.value.upper, 39 + 49);
  EXPECT_LE(found.product_states, 2'000U);
}

// The least that can be is an answer where little is good, and none where much is.
TEST(CaseAnswer, NothingIsAnAnswerWhereLittleIsGood) {
  for (const auto& [formula, query] :
       {std::pair("F a", CaseTask::Query::MinProbability), std::pair("!x", CaseTask::Query::MinCost)}) {
    const CaseAnswer least = noisy_answer(formula, query);
    EXPECT_EQ(least.status, CaseAnswer::Status::Solved) << formula;
    EXPECT_EQ(least.value.upper, 0) << formula;
  }
  for (const CaseTask::Query query : {CaseTask::Query::MaxProbability, CaseTask::Query::Discounted}) {
    const CaseAnswer most = noisy_answer("F nowhere", query);
    EXPECT_EQ(most.status, CaseAnswer::Status::Infeasible);
    EXPECT_EQ(most.value.upper, 0);
  }
}

TEST(CaseAnswer, CyclesAreAskedForAsPatrols) {
  CaseTask patrol{.id = "", .formula = "patrol:a,b", .logic = CaseTask::Logic::Derived};
  patrol.query = CaseTask::Query::MinCycle;
  CaseTask formula = patrol, ltl = patrol;
  formula.formula = "G F a & G F b";
  ltl.logic = CaseTask::Logic::Ltl;
  EXPECT_EQ(answer(plain_corridor(), patrol).status, CaseAnswer::Status::Solved);
  EXPECT_THROW(answer(plain_corridor(), formula), std::invalid_argument);
  EXPECT_THROW(answer(plain_corridor(), ltl), std::invalid_argument);
}

// Words of routes are certified as what they are: beginnings of infinite words, or finite ones, of past operators too.
TEST(CaseAnswer, RoutesAreCertifiedWhateverTheirFormulas) {
  const auto cost = [](const char* formula, CaseTask::Logic logic) {
    return answer(plain_corridor(), {.id = "", .formula = formula, .logic = logic, .query = CaseTask::Query::MinCost})
        .value.upper;
  };
  EXPECT_EQ(cost("F (a & (X b | X X !b | X (!b & X b)))", CaseTask::Logic::Ltl), 5) << "whatever comes after `a`";
  EXPECT_EQ(cost("F (a & X b)", CaseTask::Logic::Ltl), 6);
  EXPECT_EQ(cost("F (a & N false)", CaseTask::Logic::Ltlf), 5) << "at the end";
  EXPECT_EQ(cost("F (a & O b)", CaseTask::Logic::Ltlf), 5) << "`b` is on the way";
  EXPECT_EQ(cost("F (b & O a)", CaseTask::Logic::Ltlf), 6) << "and not before `a` at the first time";
}

}  // namespace
}  // namespace waymark::plan
