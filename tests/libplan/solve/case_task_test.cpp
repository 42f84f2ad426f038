// Planning cases: the values of the open ones, methods, reasons.
#include "libplan/solve/case_task.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/places.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

// A corridor of five cells, hazard in the middle of the upper row.
constexpr const char* small_case = R"({"format": "ltlgrid/1", "name": "small", "width": 5, "height": 2,
  "rows": ["..x.a", "s...b"], "legend": {"x": {"props": ["x"]}, "a": {"props": ["a"]}, "b": {"props": ["b"]}, "s": {}},
  "start": {"x": 0, "y": 1}, "motion": {"forward": 0.8, "left": 0.1, "right": 0.1, "back": 0}})";

CaseAnswer ask(const std::string& formula, CaseTask::Query query, CaseTask::Logic logic = CaseTask::Logic::Ltl) {
  return answer(parse_case(small_case), {.id = "", .formula = formula, .logic = logic, .query = query});
}

TEST(CaseTask, LeastAndGreatestProbabilitiesAreComplements) {
  for (const char* formula : {"F a", "!x U a", "G F b", "F G !x", "F<=7 a", "G(a -> F b)"}) {
    const CaseAnswer most = ask(std::string("!(") + formula + ")", CaseTask::Query::MaxProbability);
    const CaseAnswer least = ask(formula, CaseTask::Query::MinProbability);
    ASSERT_NE(least.status, CaseAnswer::Status::Exhausted) << formula;
    EXPECT_NEAR(least.value.middle(), 1 - most.value.middle(), 1e-6) << formula;
  }
}

// The end of a prefix is no end of the word: X under a negation, or on one side of <->, must not be satisfied by it.
TEST(CaseTask, NextsKnowNoEndOfInfiniteWords) {
  const PlanningCase line = parse_case(R"({"format": "ltlgrid/1", "width": 3, "height": 1, "rows": [".b."],
    "legend": {"b": {"props": ["b"]}}, "start": {"x": 0, "y": 0},
    "motion": {"forward": 0.5, "left": 0.25, "right": 0.25}})");
  const auto value = [&](const char* formula, CaseTask::Query query) {
    return answer(line, {.id = "", .formula = formula, .query = query}).value.middle();
  };
  EXPECT_NEAR(value("b <-> X b", CaseTask::Query::MinProbability), 0.5, 1e-6);
  EXPECT_NEAR(value("X(!b & X(b <-> X !b))", CaseTask::Query::MaxProbability), 0.5, 1e-6);
  EXPECT_NEAR(value("!(b <-> X b)", CaseTask::Query::MaxProbability), 0.5, 1e-6);
}

// Noise in all directions: a hazard can be put off for ages, not avoided.
TEST(CaseTask, WhatCanOnlyBePutOffIsCertain) {
  const PlanningCase noisy = parse_case(R"({"format": "ltlgrid/1", "width": 30, "height": 1,
    "rows": ["s............................x"], "legend": {"s": {}, "x": {"props": ["x"]}}, "start": {"x": 0, "y": 0},
    "motion": {"forward": 0.85, "left": 0.05, "right": 0.05, "back": 0.05}})");
  const CaseAnswer least = answer(
      noisy, {.id = "", .formula = "F x", .logic = CaseTask::Logic::Ltl, .query = CaseTask::Query::MinProbability});
  EXPECT_EQ(least.status, CaseAnswer::Status::Solved);
  EXPECT_EQ(least.value.lower, 1);
}

// With noise in all directions, far from both a and b, lingering is worth as much as leaving but for what doubles tell.
TEST(CaseTask, LeastProbabilitiesAreProvedWhereStrategiesMayLinger) {
  std::vector<std::string> rows(12, std::string(37, '.'));
  rows[1][1] = 'b';
  rows[0][17] = 'a';
  rows[6][24] = rows[7][24] = rows[4][31] = '#';
  std::string map;
  for (const std::string& row : rows) map += (map.empty() ? "\"" : ", \"") + row + "\"";
  const auto from = [&](const char* start) {
    return parse_case(R"({"format": "ltlgrid/1", "width": 37, "height": 12, "rows": [)" + map +
                      R"(], "legend": {"#": {"wall": true}, "a": {"props": ["a"]}, "b": {"props": ["b"]}},
      "start": )" + start +
                      R"(, "motion": {"forward": 0.7, "left": 0.1, "right": 0.1, "back": 0.1}})");
  };
  for (const char* start : {R"({"x": 6, "y": 5})", R"({"x": 17, "y": 1})", R"({"x": 36, "y": 11})"}) {
    const auto ask = [&](const char* formula, CaseTask::Query query) {
      return answer(from(start), {.id = "", .formula = formula, .query = query});
    };
    const CaseAnswer least = ask("(!b) U a", CaseTask::Query::MinProbability);
    const CaseAnswer most = ask("!((!b) U a)", CaseTask::Query::MaxProbability);
    ASSERT_EQ(least.status, CaseAnswer::Status::Solved) << start;
    EXPECT_LE(least.value.upper - least.value.lower, 1e-6) << start;
    EXPECT_LE(1 - most.value.upper, least.value.upper) << start;
    EXPECT_GE(1 - most.value.lower, least.value.lower) << start;
  }
}

// Two halves and a bridge with lava on both sides, noise in all directions: choices that only put off the crossing are
// worth the same in doubles as those that go on. Against sweeps of the cells from below, written here.
class Bridge {
 public:
  Bridge(int size, int width, double slip) : size_(size), slip_(slip), rows_(at(size), std::string(at(size), '.')) {
    const int from = (size - size / 5) / 2, top = size / 2;
    for (int y = 0; y < size; ++y)
      for (int x = from; x < from + size / 5; ++x)
        if (y < top || y >= top + width) rows_[at(y)][at(x)] = y == top - 1 || y == top + width ? 'x' : '#';
    rows_[2][at(size - 3)] = 'a';
  }

  PlanningCase planning_case() const {
    std::string listed;
    for (const std::string& row : rows_) listed += (listed.empty() ? "\"" : ", \"") + row + '"';
    const std::string side = std::to_string(size_), slip = std::to_string(slip_);
    return parse_case("{\"format\": \"ltlgrid/1\", \"width\": " + side + ", \"height\": " + side + ", \"rows\": [" +
                      listed + "], \"start\": {\"x\": 2, \"y\": " + std::to_string(size_ / 2) +
                      R"(}, "legend": {"#": {"wall": true}, "x": {"props": ["x"]}, "a": {"props": ["a"]}},)" +
                      "\"motion\": {\"forward\": " + std::to_string(1 - 3 * slip_) + ", \"left\": " + slip +
                      ", \"right\": " + slip + ", \"back\": " + slip + ", \"blocked\": \"stay\"}}");
  }

  double value() const {
    std::vector<double> value(at(size_ * size_), 0);
    const int dx[] = {0, 1, 0, -1}, dy[] = {-1, 0, 1, 0};
    const auto beyond = [&](int x, int y, int d) {
      const int tx = x + dx[d % 4], ty = y + dy[d % 4];
      const bool free = tx >= 0 && ty >= 0 && tx < size_ && ty < size_ && rows_[at(ty)][at(tx)] != '#';
      return value[at(free ? ty * size_ + tx : y * size_ + x)];
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x) {
          const char cell = rows_[at(y)][at(x)];
          double best = cell == 'a' ? 1 : 0;
          for (int d = 0; d < 4 && cell == '.'; ++d)
            best = std::max(best, (1 - 3 * slip_) * beyond(x, y, d) +
                                      slip_ * (beyond(x, y, d + 1) + beyond(x, y, d + 2) + beyond(x, y, d + 3)));
          changed = changed || best > value[at(y * size_ + x)] + 1e-14;
          value[at(y * size_ + x)] = best;
        }
    }
    return value[at(size_ / 2 * size_ + 2)];
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int size_;
  double slip_;
  std::vector<std::string> rows_;
};

TEST(CaseTask, WhatCanBePutOffAlmostForEverIsAnswered) {
  std::vector<Bridge> bridges{Bridge(50, 1, 0.05)};
  if (!::waymark::testing::sanitized) bridges.insert(bridges.end(), {Bridge(60, 3, 0.15), Bridge(40, 1, 0.2)});
  for (const Bridge& bridge : bridges) {
    const PlanningCase lava = bridge.planning_case();
    const double value = bridge.value();
    for (const CaseMethod method : {CaseMethod::Best, CaseMethod::ValueIteration, CaseMethod::PolicyIteration}) {
      const CaseAnswer most =
          answer(lava, {.id = "", .formula = "!x U a", .query = CaseTask::Query::MaxProbability}, {.method = method});
      ASSERT_EQ(most.status, CaseAnswer::Status::Solved) << most.reason;
      EXPECT_EQ(most.reason, "");
      EXPECT_NEAR(most.value.middle(), value, 1e-6);
      EXPECT_LE(most.value.lower, value + 1e-9);  // what sweeps that hardly change leave out
      EXPECT_GE(most.value.upper, value);
    }
  }
}

// The corridor without noise.
PlanningCase quiet_case() {
  std::string text = small_case;
  return parse_case(text.replace(text.find(R"(, "motion")"), std::string::npos, "}"));
}

TEST(CaseTask, SaysWhichMethodItWas) {
  const PlanningCase noisy = parse_case(small_case);
  const CaseTask task{.id = "", .formula = "F a", .query = CaseTask::Query::MaxProbability};
  for (const auto& [asked, done] : {std::pair(CaseMethod::Best, CaseMethod::ValueIteration),
                                    std::pair(CaseMethod::ValueIteration, CaseMethod::ValueIteration),
                                    std::pair(CaseMethod::PolicyIteration, CaseMethod::PolicyIteration)}) {
    const CaseAnswer found = answer(noisy, task, {.method = asked});
    EXPECT_TRUE(found.method == done);
    EXPECT_EQ(found.reason, "");
  }
}

TEST(CaseTask, AsManyRoutesAsAskedFor) {
  const CaseTask cheapest{.id = "", .formula = "F a", .query = CaseTask::Query::MinCost};
  for (const std::size_t top : {1U, 2U, 3U}) {
    EXPECT_EQ(answer(quiet_case(), cheapest, {.top = top, .route = true}).routes.size(), top);
    EXPECT_EQ(answer(quiet_case(), cheapest, {.top = top}).routes.size(), top == 1 ? 0 : top);
  }
}

TEST(CaseTask, MethodSearchIsForCostsOfDeterministicModels) {
  const CaseTask cheapest{.id = "", .formula = "F a", .query = CaseTask::Query::MinCost};
  const CaseTask likeliest{.id = "", .formula = "F a", .query = CaseTask::Query::MaxProbability};
  const CaseOptions by_search{.method = CaseMethod::Search};
  EXPECT_EQ(answer(quiet_case(), cheapest, by_search).value.upper, 5);
  EXPECT_THROW(answer(quiet_case(), likeliest, by_search), std::invalid_argument);
  EXPECT_THROW(answer(parse_case(small_case), cheapest, by_search), std::invalid_argument);
  const CaseTask lasso{.id = "", .formula = "G F a", .query = CaseTask::Query::LeastLasso};
  EXPECT_EQ(answer(quiet_case(), lasso, by_search).status, answer(quiet_case(), lasso, CaseOptions{}).status);
  CaseTask round{.id = "", .formula = "patrol:a,b", .logic = CaseTask::Logic::Derived};
  round.query = CaseTask::Query::MinCycle;
  for (const CaseOptions& options : {by_search, CaseOptions{}})
    EXPECT_EQ(answer(quiet_case(), round, options).value.upper, 2);
  for (const CaseTask& task : {lasso, round})
    EXPECT_THROW(answer(quiet_case(), task, {.method = CaseMethod::PolicyIteration}), std::invalid_argument);
  EXPECT_EQ(answer(quiet_case(), cheapest, {.top = 3}).routes.size(), 3U);
  EXPECT_THROW(answer(quiet_case(), likeliest, {.top = 2}), std::invalid_argument);
  EXPECT_THROW(answer(parse_case(small_case), cheapest, {.top = 2}), std::invalid_argument);
}

TEST(CaseTask, TheStrategyOfASearchGoesAlongTheRoute) {
  const CaseAnswer found = answer(quiet_case(), {.id = "", .formula = "F a", .query = CaseTask::Query::MinCost},
                                  {.route = true, .strategy = true});
  ASSERT_TRUE(found.strategy);
  ASSERT_EQ(found.routes.size(), 1U);
  EXPECT_EQ(found.strategy->re_evaluated.lower, 5);
  EXPECT_EQ(found.strategy->re_evaluated.upper, 5);
  ASSERT_EQ(found.strategy->decisions.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(found.strategy->decisions[i].place, found.routes[0].places[i]);
    EXPECT_EQ(found.strategy->decisions[i].action, found.routes[0].actions[i]);
  }
}

TEST(CaseTask, WhatIsNotAskedForIsNotTold) {
  const CaseAnswer found = answer(quiet_case(), {.id = "", .formula = "F a", .query = CaseTask::Query::MinCost});
  EXPECT_TRUE(found.routes.empty());
  EXPECT_FALSE(found.strategy);
  EXPECT_FALSE(found.lasso);
}

// A thousandth of the states is for the automaton, of which this one needs more.
TEST(CaseTask, SaysWhichLimitWasMet) {
  const CaseTask task{
      .id = "", .formula = "F (a & X F b) & F (b & X F x) & F (x & X F a)", .query = CaseTask::Query::MaxProbability};
  const CaseAnswer automaton = answer(parse_case(small_case), task, {.states = 4'000});
  EXPECT_EQ(automaton.status, CaseAnswer::Status::Exhausted);
  EXPECT_EQ(automaton.reason, "no automaton within the limits");
  EXPECT_EQ(automaton.seconds.solve, 0) << "which it did not come to";
  const CaseTask small{.id = "", .formula = "F a", .query = CaseTask::Query::MaxProbability};
  EXPECT_EQ(answer(parse_case(small_case), small, {.states = 2'000}).status, CaseAnswer::Status::Solved);
  EXPECT_EQ(answer(parse_case(small_case), task, {.states = 1'000'000}).status, CaseAnswer::Status::Solved);
}

TEST(CaseTask, WhatHoldsAtTheStartIsSeen) {
  const PlanningCase line = parse_case(R"({"format": "ltlgrid/1", "width": 2, "height": 1, "rows": ["sa"],
    "legend": {"s": {"props": ["s"]}, "a": {"props": ["a"]}}, "start": {"x": 0, "y": 0}})");
  const CaseAnswer found =
      answer(line, {.id = "", .formula = "F s & F a & F nowhere", .query = CaseTask::Query::MinCost});
  EXPECT_NE(found.reason.find("never seen from the start: nowhere"), std::string::npos) << found.reason;
}

// Landmarks of large models are toured without a product; what is asked for on the way to them keeps it from that.
TEST(CaseTask, OnlyVisitsAreTours) {
  constexpr std::size_t size = 320;
  std::string rows = "\"s.a.b" + std::string(size - 5, '.') + '"';
  for (std::size_t y = 1; y < size; ++y) rows += ", \"" + std::string(size, '.') + '"';
  const PlanningCase open = parse_case(R"({"format": "ltlgrid/1", "width": 320, "height": 320, "rows": [)" + rows +
                                       R"(], "legend": {"a": {"props": ["a"]}, "b": {"props": ["b"]}, "s": {}},
    "start": {"x": 0, "y": 0}})");
  const auto ask = [&](const char* formula, bool route = false) {
    return answer(open, {.id = "", .formula = formula, .query = CaseTask::Query::MinCost},
                  {.explain = false, .route = route});
  };
  const CaseAnswer visits = ask("F a & F b");
  EXPECT_TRUE(visits.routes.empty());
  EXPECT_EQ(ask("F a & F b", true).routes.size(), 1U);
  EXPECT_EQ(visits.value.upper, 4);
  EXPECT_EQ(visits.product_states, 0U) << "no product";
  EXPECT_EQ(visits.product_edges, 0U);
  EXPECT_EQ(visits.automaton_states, 0U) << "no automaton";
  EXPECT_EQ(visits.seconds.automaton + visits.seconds.product, 0);
  EXPECT_EQ(ask("(b U a) & (a U b)").status, CaseAnswer::Status::Infeasible);
  EXPECT_EQ(ask("(!b U a) & (!a U (b | a))").value.upper, 2);
}

TEST(CaseTask, SaysWhichConjunctsAreInTheWay) {
  const CaseAnswer answer = ask("F a & G !a & F b", CaseTask::Query::MaxProbability);
  EXPECT_EQ(answer.status, CaseAnswer::Status::Infeasible);
  EXPECT_EQ(answer.dropped.size(), 1U);
  EXPECT_NE(answer.reason.find("together"), std::string::npos) << answer.reason;
  const CaseAnswer unseen = ask("F nowhere", CaseTask::Query::MinCost);
  EXPECT_EQ(unseen.status, CaseAnswer::Status::Infeasible);
  EXPECT_NE(unseen.reason.find("never seen from the start: nowhere"), std::string::npos) << unseen.reason;
  const CaseAnswer several = ask("F (here & there & a)", CaseTask::Query::MinCost);
  EXPECT_NE(several.reason.find("never seen from the start: here, there"), std::string::npos) << several.reason;
}

// A cost is finite where the goal is sure to be reached: by chance is not enough.
TEST(CaseTask, AllConjunctsGoWithoutWhichTheRestIsSure) {
  const PlanningCase line = parse_case(R"({"format": "ltlgrid/1", "width": 4, "height": 1, "rows": ["xsab"],
    "legend": {"x": {"props": ["x"]}, "s": {}, "a": {"props": ["a"]}, "b": {"props": ["b"]}},
    "start": {"x": 1, "y": 0}, "motion": {"forward": 0.8, "back": 0.2}})");
  const CaseAnswer least =
      answer(line, {.id = "", .formula = "(!x U a) & (!x U b) & F(b & X F a)", .query = CaseTask::Query::MinCost});
  EXPECT_EQ(least.status, CaseAnswer::Status::Infeasible);
  EXPECT_EQ(least.dropped, (std::vector<std::string>{"!x U a", "!x U b"}));
}

// A cycle through the start needs no way to it; there and back again between a and b is the shortest cycle.
TEST(CaseTask, ALassoIsWorthWhatItsOrderPutsFirst) {
  const CaseTask lasso{.id = "", .formula = "G F a & G F b", .query = CaseTask::Query::LeastLasso};
  const auto value = [&](LassoOrder order) { return answer(quiet_case(), lasso, {.order = order}).value.upper; };
  EXPECT_EQ(value(LassoOrder::Prefix), 0);
  EXPECT_EQ(value(LassoOrder::Cycle), 2);
  EXPECT_EQ(value(LassoOrder::Mean), 2);
}

TEST(CaseTask, AWalkHasNoStrategy) {
  const CaseTask lasso{.id = "", .formula = "G F a", .query = CaseTask::Query::LeastLasso};
  EXPECT_THROW(answer(quiet_case(), lasso, {.strategy = true}), std::invalid_argument);
}

TEST(CaseTask, MethodsAgree) {
  const PlanningCase planning_case = parse_case(small_case);
  for (const char* formula : {"F a", "F a & F b", "!x U b"}) {
    const CaseTask task{.id = "", .formula = formula, .logic = CaseTask::Logic::Ltl, .query = CaseTask::Query::MinCost};
    const CaseAnswer sweeps = answer(planning_case, task, {.method = CaseMethod::ValueIteration});
    const CaseAnswer solves = answer(planning_case, task, {.method = CaseMethod::PolicyIteration});
    EXPECT_EQ(sweeps.status, solves.status) << formula;
    if (sweeps.status == CaseAnswer::Status::Solved) {
      EXPECT_NEAR(sweeps.value.middle(), solves.value.middle(), 1e-5) << formula;
    }
  }
}

// ../shared/plan/values.tsv, line by line.
TEST(CaseTask, ReproducesTheValuesOfTheOpenCases) {
  const auto folder = waymark::testing::shared() / "plan";
  std::ifstream in(folder / "values.tsv");
  if (!in) GTEST_SKIP() << "no " << folder / "values.tsv";
  std::string line, last;
  std::getline(in, line);
  std::optional<PlanningCase> planning_case;
  int checked = 0;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    std::string name, id, query, lower, upper;
    row >> name >> id >> query >> lower >> upper;
    if (name != last) planning_case = read_case(folder / "cases" / (name + ".json"));
    last = name;
    const bool noisy = name.find("-p") != std::string::npos;
    if (noisy && waymark::testing::sanitized) continue;  // minutes there; the same code runs on the others
    for (const CaseTask& task : planning_case->tasks) {
      if (task.id != id) continue;
      const CaseAnswer found = answer(*planning_case, task);
      ASSERT_NE(found.status, CaseAnswer::Status::Exhausted) << line;
      const double lo = std::stod(lower), hi = std::stod(upper);
      const bool is_cost = query == "rmin" || query == "steps" || query == "cycle";
      const double room = !is_cost ? 1e-6 : noisy ? 1e-6 * lo : 0;
      EXPECT_TRUE(std::isinf(lo) ? std::isinf(found.value.lower)
                                 : found.value.middle() >= lo - room && found.value.middle() <= hi + room)
          << line << ": " << found.value.lower << " to " << found.value.upper;
      ++checked;
    }
  }
  EXPECT_GT(checked, 0);
}

}  // namespace
}  // namespace waymark::plan
