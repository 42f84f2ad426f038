#include "libplan/learn/observations.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libltl/meaning/progress.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/learn/task_trees.hpp"
#include "libplan/solve/route_planner.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

// The fewest actions to a proposition are the cost of the plan of F p.
TEST(Observations, AreThePlansOfSingleGoals) {
  for (const Map& map : {plus(), shipped("grid")})
    for (const char* name : {"sofa", "blue", "ahead_fish"}) {
      const auto distance = actions_to(map, map.vocabulary().find(name).value());
      const automata::Dfa dfa = dfa_of(std::string("F ") + name);
      RoutePlanner planner(map, dfa);
      for (std::uint32_t i = 0; i < map.poses(); ++i) {
        const auto planned = planner.plan(PoseId{i});
        const auto* route = std::get_if<Route>(&planned);
        ASSERT_EQ(distance[i].has_value(), route != nullptr);
        if (route == nullptr) continue;
        EXPECT_EQ(*distance[i], route->cost) << map.name() << ' ' << name;
      }
    }
}

TEST(Observations, LiteralDistancesDoNotSeeTheHeading) {
  const Map map = hallway(3);
  const Observations literal = observe(map, Sight::Literal), objects = observe(map, Sight::Objects);
  ASSERT_EQ(literal.names[0], "chair");
  const auto row = [&](const Observations& seen, int heading) {
    return seen.by_position(0, pose_at(map, 1, 0, heading).index);
  };
  for (const int heading : {90, 180, 270}) EXPECT_EQ(row(literal, heading), row(literal, 0));
  EXPECT_LT(row(objects, 90), row(objects, 0));
  EXPECT_EQ(row(literal, 0), 2.0F / 3);
  EXPECT_EQ(literal.by_position.row(1).minCoeff(), 1);  // there is no sofa
  EXPECT_EQ(observe(map, Sight::Landmarks).names,
            (std::vector<std::string>{"chair", "sofa", "blue", "brick", "ahead_fish"}));
}

// A map's model is seen as the map is, up to the scale.
TEST(Observations, OfAModelAreThoseOfItsMap) {
  const Map map = shipped("grid");
  const Observations of_model = observe(mdp_of(map, PoseId{0}));
  for (const char* name : {"sofa", "blue", "ahead_fish"}) {
    const auto distance = actions_to(map, map.vocabulary().find(name).value());
    const auto found = std::find(of_model.names.begin(), of_model.names.end(), name);
    ASSERT_NE(found, of_model.names.end()) << name;
    const auto row = of_model.by_position.row(found - of_model.names.begin());
    float scale = 0;
    for (std::uint32_t i = 0; i < map.poses(); ++i)
      if (distance[i].value() > 0) scale = row(i) / static_cast<float>(*distance[i]);
    for (std::uint32_t i = 0; i < map.poses(); ++i)
      EXPECT_FLOAT_EQ(row(i), scale * static_cast<float>(*distance[i])) << name;
  }
}

// The formula of a state accepts the words that the automaton accepts from there.
TEST(TaskTrees, FormulasMeanWhatTheirStatesAccept) {
  const Map map = square();
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula phi = ltl::parse("F (sofa & X F blue) & !moved W turned_left", arena);
  const automata::Dfa dfa = automata::ltlf_to_dfa(phi);
  const TabularProduct product = tabulate(map, dfa, PoseId{0});
  const auto formulas = formulas_of(product.task, phi);
  std::size_t known = 0;
  for (std::uint32_t q = 0; q < product.task.tasks; ++q) {
    if (!formulas[q]) continue;
    ++known;
    for (std::uint32_t letter = 0; letter < product.task.letters; ++letter) {
      const std::uint32_t next = product.task.after(q, letter);
      EXPECT_EQ(ltl::accepts_empty(ltl::progress(*formulas[q], product.task.classes.representatives()[letter])),
                product.task.ending[next] == Ending::Accepting);
    }
  }
  EXPECT_GE(known, 4U);
  const TaskTrees trees = trees_of(product.task, phi);
  ASSERT_EQ(trees.root.size(), product.task.tasks);
  for (std::size_t v = 0; v < trees.nodes.size(); ++v)
    for (const auto& child : trees.nodes[v].children) EXPECT_LT(child.node, static_cast<neural::Index>(v));
}

}  // namespace
}  // namespace waymark::plan
