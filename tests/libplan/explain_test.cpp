#include "libplan/solve/explain.hpp"

#include <gtest/gtest.h>

#include <set>

#include "libautomata/bdd/mtbdd.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/plan_of.hpp"
#include "libplan/product/task_steps.hpp"
#include "libplan/solve/route_planner.hpp"
#include "tests/libplan/maps.hpp"
#include "tests/libplan/solvers.hpp"

namespace waymark::plan {
namespace {

std::string reason(const Map& map, const std::string& formula, const std::vector<PoseId>& starts) {
  ltl::Arena arena;
  const Planned planned = plan_of(map, ltl::parse(formula, arena), starts);
  const auto* infeasible = std::get_if<Infeasible>(&planned);
  return infeasible == nullptr ? "feasible" : infeasible->reason;
}

TEST(Explain, NamesTheSmallestPartThatIsTooMuch) {
  const Map map = hallway(3);
  const PoseId start = pose_at(map, 0, 0, 90);
  EXPECT_EQ(reason(map, "F chair", {start}), "feasible");
  EXPECT_EQ(reason(map, "moved & !moved", {start}), "no finite word satisfies the formula: it contradicts itself");
  EXPECT_EQ(reason(map, "G moved & F (X X !moved)", {start}),
            "no finite word satisfies the formula: it contradicts itself");
  EXPECT_EQ(reason(map, "F sofa", {start}),
            "no route from (0,0,90) satisfies the formula; never seen from there: sofa");
  EXPECT_EQ(reason(map, "F chair & F sofa & X moved", {start}),
            "no route from (0,0,90) satisfies F sofa; never seen from there: sofa");
  EXPECT_EQ(reason(map, "X chair & F brick", {start}), "no route from (0,0,90) satisfies X chair");
  EXPECT_EQ(reason(map, "F brick & F chair & G !corridor", {start, pose_at(map, 0, 0, 180)}),
            "no route from (0,0,90) or (0,0,180) satisfies F chair and G !corridor together");
}

// Whatever the order of the conjuncts: what can be left out is, and every name is there. To see the chair one goes over
// brick, and along the corridor.
TEST(Explain, NamesNoMoreThanIsTooMuchAndAllOfIt) {
  const Map map = hallway(3), round = square();
  const PoseId start = pose_at(map, 0, 0, 90);
  for (const char* formula : {"F brick & F chair & G !corridor", "F chair & F brick & G !corridor",
                              "F chair & G !corridor & F brick", "G !corridor & F brick & F chair & F blue"}) {
    const std::string why = reason(map, formula, {start}), together = " together",
                      begin = "no route from (0,0,90) satisfies ";
    ASSERT_TRUE(why.starts_with(begin) && why.ends_with(together)) << why;
    const std::string part = why.substr(begin.size(), why.size() - begin.size() - together.size());
    const std::set<std::string> parts{"F chair and G !corridor", "G !corridor and F chair", "F brick and G !corridor",
                                      "G !corridor and F brick"};
    EXPECT_TRUE(parts.contains(part)) << why;
  }
  EXPECT_EQ(
      reason(round, "F chair & F ahead_fish & F sofa", {pose_at(round, 0, 0, 90)}),
      "no route from (0,0,90) satisfies F chair and F ahead_fish together; never seen from there: ahead_fish, chair");
}

// More propositions than a translation takes.
TEST(Explain, SaysLittleWhereItWouldTakeTooMuch) {
  std::string formula = "p0";
  for (std::uint32_t i = 1; i <= automata::Mtbdd::max_variables; ++i) formula += " & p" + std::to_string(i);
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(formula, arena);
  ASSERT_TRUE(std::holds_alternative<automata::Exhausted>(automata::ltlf_to_dfa(f, ltl::Limits{})));
  const PoseId start{0};
  EXPECT_EQ(explain_infeasible(hallway(3), f, {&start, 1}, {}).reason, "no route satisfies the formula");
}

TEST(Explain, StopsWhenAsked) {
  const Map map = hallway(3);
  ltl::Arena arena;
  std::stop_source source;
  source.request_stop();
  const PoseId start{0};
  const ltl::Formula f = ltl::parse("F chair & F sofa", arena);
  EXPECT_EQ(explain_infeasible(map, f, {&start, 1}, source.get_token()).reason, "no route satisfies the formula");
}

TEST(PlanOf, ReportsWhatTheMapLacks) {
  const Map map = shipped("grid");
  ltl::Arena arena;
  const PoseId start{0};
  // `chiar | !chiar` is dropped by translation, but it is still a proposition that no one here can see.
  EXPECT_THROW(plan_of(map, ltl::parse("F (chair & (F chiar | G !chiar))", arena), start), ltl::FormatError);
}

TEST(PlanOf, GivesUpWhenAskedOrLimited) {
  const Map map = shipped("grid");
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula f = ltl::parse("F (chair & X F (sofa & X F (easel & X F (lamp & X F hatrack))))", arena);
  const PoseId start{0};
  std::stop_source source;
  source.request_stop();
  EXPECT_TRUE(std::holds_alternative<Exhausted>(plan_of(map, f, start, {.stop = source.get_token()})));
  EXPECT_TRUE(std::holds_alternative<Exhausted>(plan_of(map, f, start, {.automaton_states = 1})));
  EXPECT_TRUE(std::holds_alternative<CertifiedRoute>(plan_of(map, f, start)));
}

TEST(Solve, GivesUpWhenAsked) {
  const Map map = shipped("grid");
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(
      ltl::parse("F place_1 & F place_2 & F place_3 & F place_4 & F place_5 & F place_6 & F place_7", arena));
  const MapProduct product = compose(map, dfa, PoseId{0});
  std::stop_source source;
  source.request_stop();
  using enum ShortestRoute::Algorithm;
  for (const auto algorithm : {AStar, Dijkstra}) {
    EXPECT_TRUE(
        std::holds_alternative<Exhausted>(solve(product, {.algorithm = algorithm, .stop = source.get_token()})));
    EXPECT_TRUE(std::holds_alternative<Solved>(solve(product, {.algorithm = algorithm})));
  }
  EXPECT_TRUE(std::holds_alternative<Exhausted>(RoutePlanner(map, dfa).plan(PoseId{0}, source.get_token())));
}

TEST(RoutePlanner, CountsWhatItLooksAt) {
  const Map map = hallway(3);
  ltl::Arena arena(map.vocabulary());
  const PoseId start = pose_at(map, 0, 0, 90);
  const automata::Dfa at_once = automata::ltlf_to_dfa(ltl::parse("!moved", arena)),
                      farther = automata::ltlf_to_dfa(ltl::parse("X moved", arena));
  RoutePlanner none(map, at_once), some(map, farther);
  EXPECT_TRUE(std::holds_alternative<Route>(none.plan(start)));
  EXPECT_EQ(none.met(), 1U);
  EXPECT_EQ(none.edges(), 0U) << "the start satisfies the task";
  EXPECT_TRUE(std::holds_alternative<Route>(some.plan(start)));
  const std::size_t edges = some.edges();
  EXPECT_GE(edges, 1U);
  EXPECT_LE(edges, 3U) << "no more than the choices of the start";
  some.plan(start);
  EXPECT_EQ(some.edges(), edges) << "counted anew for each plan";
}

TEST(RoutePlanner, SaysWhetherTheTaskOrTheMapIsToBlame) {
  const Map map = hallway(3);
  ltl::Arena arena(map.vocabulary());
  const auto reason = [&](const char* formula) {
    const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse(formula, arena));
    return std::get<Infeasible>(RoutePlanner(map, dfa).plan(pose_at(map, 0, 0, 90))).reason;
  };
  EXPECT_EQ(reason("moved & !moved"), "no finite word satisfies the task");
  EXPECT_TRUE(reason("F sofa").starts_with("no route from here satisfies the task (all ")) << reason("F sofa");
}

TEST(Solve, DijkstraKnowsTheWayFromEverywhere) {
  const Map map = shipped("l");
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F (lamp & F chair)", arena));
  const MapProduct product = compose(map, dfa, PoseId{0});
  const Outcome outcome = solve(product, {.algorithm = ShortestRoute::Algorithm::Dijkstra});
  Policy policy = std::get<Solved>(outcome).policy;
  for (auto [v, end] = vertices(product); v != end; ++v) {
    policy.start = *v;
    if (v->task != product.starts()[0].task) continue;
    const PoseId pose{v->place};
    const auto direct = RoutePlanner(map, dfa).plan(pose);
    if (TaskSteps(map, dfa).next(dfa.initial(), map.label_id(pose)).index != v->task) continue;
    EXPECT_EQ(roll_out(product, policy).actions, std::get<Route>(direct).actions) << show(map.pose(pose));
  }
}

}  // namespace
}  // namespace waymark::plan
