// Planning cases: readers' complaints, and what slips and one-way cells do.
#include <gtest/gtest.h>

#include <string>

#include "libltl/diagnostic.hpp"
#include "libplan/solve/case_task.hpp"

namespace waymark::plan {
namespace {

TEST(ReadCase, SaysWhatIsWrongAndWhere) {
  const struct {
    const char* json;
    const char* complaint;
  } table[] = {
      {"{", "malformed JSON"},
      {R"({"format": "other"})", "expected \"ltlgrid/1\" or \"ltlmap/1\""},
      {R"({"format": "ltlgrid/1", "width": 2, "height": 1, "rows": ["."], "start": {"x": 0, "y": 0}})",
       "rows[0]: expected 2 characters"},
      {R"({"format": "ltlgrid/1", "width": 1, "height": 1, "rows": ["?"], "start": {"x": 0, "y": 0}})",
       "the glyph '?' is not in the legend"},
      {R"({"format": "ltlgrid/1", "width": 1, "height": 1, "rows": ["."], "start": {"x": 1, "y": 0}})",
       "the start is off the grid"},
      {R"({"format": "ltlgrid/1", "width": 1, "height": 1, "rows": ["."], "start": {"x": 0, "y": 0},
           "motion": {"forward": 0.5}})",
       "do not add up to 1"},
      {R"({"format": "ltlmap/1", "nodes": [{"id": 3}], "edges": [{"from": 3, "to": 4, "dir": "N"}],
           "start": {"node": 3, "heading": "N"}})",
       "edges[0].to: there is no node with that id"},
      {R"({"format": "ltlmap/1", "nodes": [{"id": 3}], "edges": [], "start": {"node": 3, "heading": "N"},
           "motion": {"forward": {"forward": 1}, "left": {"stay": 0.5, "beyond": 0.5}}})",
       "motion.left: the chances of a turn leave nothing for turning"},
      {R"({"format": "ltlmap/1", "nodes": [{"id": 3}, {"id": 4}], "edges": [{"from": 3, "to": 4, "dir": "N"}],
           "start": {"node": 3, "heading": "N"}, "motion": {"forward": 0.5}})",
       "motion: state 0: the probabilities of a choice do not add up to 1"},
  };
  for (const auto& [json, complaint] : table) {
    try {
      parse_case(json, "case.json");
      ADD_FAILURE() << json << " was read";
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(complaint), std::string::npos) << error.what();
    }
  }
}

// Two hallways north of 0, one east of 1; what a slip does is worked out by hand.
TEST(ReadCase, ActionsOfHallwayMapsMaySlip) {
  const auto cost = [](const std::string& motion, const char* formula) {
    const PlanningCase map = parse_case(R"({"format": "ltlmap/1", "nodes": [{"id": 0, "props": ["s"]},
      {"id": 1, "props": ["m"]}, {"id": 2, "props": ["n"]}, {"id": 3, "props": ["e"]}],
      "edges": [{"from": 0, "to": 1, "dir": "N"}, {"from": 1, "to": 2, "dir": "N"}, {"from": 1, "to": 3, "dir": "E"}],
      "start": {"node": 0, "heading": "N"}, "motion": )" +
                                        motion + "}");
    return answer(map, {.id = "", .formula = formula, .query = CaseTask::Query::MinCost}).value.middle();
  };
  const std::string sides = R"({"forward": 0.8, "left": 0.1, "right": 0.1})";
  EXPECT_NEAR(cost(sides, "F m"), 1.25, 1e-5);  // no hallway to the sides of 0: a slip stays
  // From 1: 0.8 to 2, 0.1 into 3 with the heading kept, and 0.1 stays.
  EXPECT_NEAR(cost(sides, "F (n | e)"), 1.25 + 1 / 0.9, 1e-5);
  const std::string turns =
      R"({"forward": {"forward": 1}, "right": {"stay": 0.5}, "left": {"stay": 0.25, "beyond": 0.25}})";
  EXPECT_NEAR(cost(turns, "F e"), 1 + 2 + 1, 1e-5);  // the right turn takes two tries
  // By left turns: n = 1 + (w + s) / 2, w = 1 + s / 2, s = 1 + n / 2, so n = 3.6.
  EXPECT_NEAR(cost(R"({"forward": {"forward": 1}, "right": {"stay": 0.9}, "left": {"beyond": 0.5}})", "F e"),
              1 + 3.6 + 1, 1e-5);
  EXPECT_NEAR(cost("{}", "F e"), 3, 1e-5);
}

TEST(ReadCase, OneWayCellsAreEnteredAndLeftOneWayOnly) {
  const PlanningCase planning_case = parse_case(R"({"format": "ltlgrid/1", "width": 3, "height": 2,
    "rows": ["a>b", "..."], "legend": {"a": {"props": ["a"]}, "b": {"props": ["b"]}, ">": {"oneway": "E"}},
    "start": {"x": 2, "y": 0}})");
  const auto cost = [&](const char* formula) {
    return answer(planning_case,
                  {.id = "", .formula = formula, .logic = CaseTask::Logic::Ltl, .query = CaseTask::Query::MinCost})
        .value.lower;
  };
  EXPECT_EQ(cost("F a"), 4);         // round by the lower row
  EXPECT_EQ(cost("F(a & F b)"), 6);  // and straight back
}

}  // namespace
}  // namespace waymark::plan
