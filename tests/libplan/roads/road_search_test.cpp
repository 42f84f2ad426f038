// Routes by hierarchies against Dijkstra over the product, on every way to build a hierarchy.
#include "libplan/roads/road_search.hpp"

#include <gtest/gtest.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/roads/contract.hpp"
#include "libplan/roads/road_task.hpp"
#include "libplan/solve/certify_word.hpp"
#include "tests/libplan/roads/random_roads.hpp"

namespace waymark::plan {
namespace {

using testing::all_contractions;
using testing::random_roads;
using testing::show;

ltl::Trace word_of(const RoadGraph& graph, const RoadRoute& route) {
  std::vector<ltl::Letter> letters;
  for (const std::uint32_t node : route.nodes) letters.push_back(graph.letters()[graph.letter(node)]);
  return ltl::Trace(std::move(letters));
}

// The same cost as the referee, and a route that the definition accepts.
void expect_least(const RoadGraph& graph, ltl::Formula f, const std::string& shown) {
  const automata::Dfa dfa = automata::ltlf_to_dfa(f);
  const TaskTable task(dfa, graph.letters());
  const auto expected = testing::least_cost_on_product(graph, task);
  for (const ContractionOptions& options : all_contractions()) {
    const auto hierarchy = contract(graph, options);
    using Use = SharedLegs::Use;
    for (const auto& [kept, shared] : {std::pair{std::size_t{256}, Use::WhereFewer},
                                       std::pair{std::size_t{2}, Use::Always}, std::pair{std::size_t{0}, Use::Never}}) {
      const auto found = least_route(graph, *hierarchy, task, {.kept_legs = kept, .shared = shared});
      ASSERT_EQ(found->route.has_value(), expected.has_value()) << ltl::print(f) << '\n' << shown;
      if (!expected) continue;
      const std::string route = [&] {
        std::string out = "route";
        for (const std::uint32_t node : found->route->nodes) out += " " + RoadGraph::name(node);
        return out + "\n";
      }();
      ASSERT_EQ(static_cast<double>(found->route->cost), *expected) << ltl::print(f) << '\n' << route << shown;
      ASSERT_NO_THROW(certify_word(word_of(graph, *found->route), f, CaseTask::Logic::Ltlf)) << ltl::print(f) << shown;
    }
  }
}

TEST(RoadSearch, AgreesWithDijkstraOverTheProduct) {
  ltl::Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const testing::RandomRoads shape{.nodes = static_cast<std::uint32_t>(1 + random.below(14)),
                                     .arcs = random.below(40),
                                     .labelled = 0.1 + 0.4 * random.unit()};
    const RoadGraph graph = random_roads(random, shape);
    ltl::Arena arena(graph.letters().vocabulary());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 1 + random.below(9), .atoms = 3});
    expect_least(graph, f, show(graph) + "case " + std::to_string(i));
    if (HasFatalFailure()) return;
  }
}

TEST(RoadSearch, AgreesOnToursWithOrderAndAvoidance) {
  const std::vector<std::string> tasks{"!x U (a & (!x U b))",
                                       "!x U (a & X(!x U (b & X(!x U a))))",
                                       "!x U (a & ((!x & !b) U (b & (!b U a))))",
                                       "F(a & X(!b U (x & X(!a U b))))",
                                       "F a & F b & G !x",
                                       "F(a & F(b & F a)) & G(a -> X !x)",
                                       "(!b U a) & F b & (!x U b)",
                                       "F(x & X(x U (!x & F b)))",
                                       "G(a -> F b) & F a",
                                       "F(a & b) & F(a & !b) & F(b & !a) & G !x",
                                       "(!b U a) & F b & F x & F(a & X F a)",
                                       "(F a & F b & F x) & ((!a U b) | (!b U a))"};
  ltl::Random random(2);
  for (int i = 0; i < 150; ++i) {
    const testing::RandomRoads shape{.nodes = static_cast<std::uint32_t>(20 + random.below(60)),
                                     .arcs = 60 + random.below(120),
                                     .labelled = 0.02 + 0.2 * random.unit(),
                                     .most_cost = 30};
    const RoadGraph graph = random_roads(random, shape);
    ltl::Arena arena(graph.letters().vocabulary());
    for (const std::string& task : tasks) {
      expect_least(graph, ltl::parse(task, arena), show(graph) + "case " + std::to_string(i));
      if (HasFatalFailure()) return;
    }
  }
}

// All graphs of three nodes with a line and labels from {∅, a, x}: every arc there or not, costs 1 to 3 by position.
TEST(RoadSearch, AgreesOnAllSmallGraphs) {
  const std::vector<std::string> tasks{"!x U a",           "F(a & X F a)", "F a & G !x",
                                       "F(a & X(!a U x))", "X X a",        "F x & F a"};
  for (std::uint32_t arcs = 0; arcs < 64; ++arcs)
    for (std::uint32_t labels = 0; labels < 27; ++labels) {
      RoadGraph::Parts parts;
      parts.letters = Letters(ltl::Vocabulary(std::vector<std::string>{"a", "x"}));
      parts.letters.intern({});
      for (std::uint32_t v = 0, rest = labels; v < 3; ++v, rest /= 3) {
        ltl::Letter letter;
        if (rest % 3 != 0) letter.insert(ltl::Proposition{rest % 3 - 1});
        parts.letter.push_back(static_cast<std::uint16_t>(parts.letters.intern(letter).index));
      }
      for (std::uint32_t u = 0, bit = 0; u < 3; ++u)
        for (std::uint32_t v = 0; v < 3; ++v)
          if (u != v && ((arcs >> bit++) & 1U) != 0) {
            parts.tails.push_back(u);
            parts.arcs.push_back({v, 1 + (u + 2 * v) % 3});
          }
      const RoadGraph graph(std::move(parts));
      ltl::Arena arena(graph.letters().vocabulary());
      for (const std::string& task : tasks) {
        expect_least(graph, ltl::parse(task, arena), show(graph));
        if (HasFatalFailure()) return;
      }
    }
}

// From the start to every a in one step, from there past one node to c, and from c to a long street of d. No way to b.
RoadGraph star(std::uint32_t landmarks, std::uint32_t street) {
  RoadGraph::Parts parts;
  parts.letters = Letters(ltl::Vocabulary(std::vector<std::string>{"a", "b", "c", "d"}));
  parts.letters.intern({});
  const auto add_node = [&](std::optional<std::uint32_t> proposition) {
    ltl::Letter letter;
    if (proposition) letter.insert(ltl::Proposition{*proposition});
    parts.letter.push_back(static_cast<std::uint16_t>(parts.letters.intern(letter).index));
  };
  const auto add_arc = [&](std::uint32_t from, std::uint32_t to) {
    parts.tails.push_back(from);
    parts.arcs.push_back({to, 1});
  };
  add_node({});
  for (std::uint32_t v = 1; v <= landmarks; ++v) add_node(0);
  const std::uint32_t between = landmarks + 1, last = between + 1 + street;
  add_node({});
  add_node(2);
  for (std::uint32_t v = 0; v < street; ++v) add_node(3);
  add_node(1);
  for (std::uint32_t v = 1; v <= landmarks; ++v) {
    add_arc(0, v);
    add_arc(v, between);
  }
  for (std::uint32_t v = between; v < last; ++v) add_arc(v, v + 1);
  return RoadGraph(std::move(parts));
}

// After a, the task falls back at c to where it waits for a. All of these were entered at no more than that, so nothing
// is searched for from there: the street is never met. Of more than 64 nodes this is not looked at.
TEST(RoadSearch, LeavesOutLettersThatCanMakeNothingCheaper) {
  constexpr std::uint32_t street = 500;
  for (const std::uint32_t landmarks : {1U, 2U, 63U, 64U, 65U}) {
    const RoadGraph graph = star(landmarks, street);
    ltl::Arena arena(graph.letters().vocabulary());
    const TaskTable task(automata::ltlf_to_dfa(ltl::parse("F(a & (!c U b))", arena)), graph.letters());
    const auto hierarchy = contract(graph, {.rare = 1000, .most_rare = 1000});
    const auto found = least_route(graph, *hierarchy, task);
    EXPECT_FALSE(found->route);
    if (landmarks <= 64)
      EXPECT_LT(found->statistics.met, street) << landmarks;
    else
      EXPECT_GE(found->statistics.met, street) << landmarks;
  }
}

// Good prefixes over infinite words too, through the door that the command line uses.
TEST(RoadTask, AnswersAsOnTheModel) {
  ltl::Random random(3);
  for (int i = 0; i < 300; ++i) {
    const RoadGraph graph =
        random_roads(random, {.nodes = static_cast<std::uint32_t>(2 + random.below(12)), .arcs = 20});
    const auto hierarchy = contract(graph);
    const PlanningCase model{"roads", model_of(graph), {}};
    ltl::Arena arena(graph.letters().vocabulary());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 1 + random.below(8), .atoms = 3});
    for (const auto query : {CaseTask::Query::MinCost, CaseTask::Query::MinSteps}) {
      const CaseTask task{"", ltl::print(f),
                          query == CaseTask::Query::MinCost ? CaseTask::Logic::Ltl : CaseTask::Logic::Ltlf, query};
      const CaseAnswer expected = answer(model, task, {.method = CaseMethod::Search});
      const CaseAnswer found = answer(graph, *hierarchy, task, {.method = CaseMethod::Search, .route = true});
      ASSERT_EQ(found.status, expected.status) << task.formula << '\n' << show(graph);
      ASSERT_EQ(found.value.upper, expected.value.upper) << task.formula << '\n' << show(graph);
      ASSERT_EQ(found.dropped, expected.dropped) << task.formula << '\n' << show(graph);
    }
  }
}

TEST(RoadTask, RefusesWhatNeedsAProduct) {
  const RoadGraph graph = [] {
    ltl::Random random(4);
    return random_roads(random, {});
  }();
  const auto hierarchy = contract(graph);
  EXPECT_THROW(answer(graph, *hierarchy, {"", "F a", CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability}),
               std::invalid_argument);
}

}  // namespace
}  // namespace waymark::plan
