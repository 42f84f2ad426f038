#include "libplan/learn/tabular_product.hpp"

#include <gtest/gtest.h>

#include <map>

#include "libltl/diagnostic.hpp"
#include "libplan/learn/environment.hpp"
#include "libplan/product/compose.hpp"
#include "libplan/product/task_steps.hpp"
#include "tests/libplan/learn/tasks.hpp"

namespace waymark::plan {
namespace {

TEST(TabularProduct, IsTheBuiltProductWhereThatIsReachable) {
  for (const Map& map : {hallway(3), square(), plus(), shipped("l")})
    for (const char* formula :
         {"F (sofa & X F chair)", "!blue U chair", "F sofa & G !turned_left", "X X moved"}) {
      const automata::Dfa dfa = dfa_of(formula);
      const Product built = compose(map, dfa, PoseId{0});
      const TabularProduct flat = tabulate(map, dfa, PoseId{0});
      ASSERT_EQ(flat.names, (std::vector<std::string>{"FORWARD", "LEFT", "RIGHT"}));
      EXPECT_TRUE(flat.is_deterministic());
      const auto number = [&](const ProductState& s) { return flat.state(s.pose.index, s.task.index); };
      ASSERT_EQ(flat.starts.size(), 1U);
      EXPECT_EQ(flat.starts[0].state, number(built.graph[built.starts[0]]));
      for (ProductVertex v = 0; v < num_vertices(built.graph); ++v) {
        const ProductState& from = built.graph[v];
        EXPECT_EQ(flat.ending(number(from)) == Ending::Accepting, built.is_accepting(v));
        EXPECT_EQ(flat.ending(number(from)) == Ending::Trap, built.is_trap(v));
        for (auto [e, end] = out_edges(v, built.graph); e != end; ++e) {
          const auto action = static_cast<std::uint32_t>(built.graph[*e].action);
          const auto outcomes = flat.outcomes_of(from.pose.index, action);
          ASSERT_EQ(outcomes.size(), 1U);
          EXPECT_EQ(flat.state(outcomes[0].position, flat.task.after(from.task.index, outcomes[0].letter)),
                    number(built.graph[target(*e, built.graph)]))
              << map.name() << "  " << formula;
        }
      }
    }
}

TEST(TabularProduct, ForwardIntoAWallIsNotOffered) {
  const Map map = hallway(2);
  const TabularProduct product = task_on(map, "F chair");
  const std::uint32_t north = pose_at(map, 0, 0, 0).index, east = pose_at(map, 0, 0, 90).index;
  EXPECT_FALSE(product.is_offered(north, 0));
  EXPECT_TRUE(product.is_offered(east, 0));
  EXPECT_TRUE(product.is_offered(north, 1));
}

TEST(TabularProduct, KeepsTheChancesOfTheModel) {
  const Map map = plus();
  const TabularProduct product = task_on(map, "F chair", PoseId{0}, slippery);
  EXPECT_FALSE(product.is_deterministic());
  const PoseId centre = pose_at(map, 1, 1, 90);
  double before = 0;
  std::map<std::uint32_t, double> chance;
  for (const auto& o : product.outcomes_of(centre.index, 0)) {
    chance[o.position] += o.up_to - before;
    before = o.up_to;
  }
  EXPECT_EQ(before, 1);
  EXPECT_NEAR(chance[pose_at(map, 2, 1, 90).index], 0.7, 1e-12);
  EXPECT_NEAR(chance[pose_at(map, 1, 0, 90).index], 0.1, 1e-12);
  EXPECT_NEAR(chance[pose_at(map, 1, 2, 90).index], 0.15, 1e-12);
  EXPECT_NEAR(chance[pose_at(map, 0, 1, 90).index], 0.05, 1e-12);
}

TEST(TabularProduct, TheLabelOfTheStartIsRead) {
  const Map map = hallway(2);
  const PoseId chair = pose_at(map, 2, 0, 0);
  EXPECT_TRUE(task_on(map, "F chair", chair).is_over());
  EXPECT_FALSE(task_on(map, "F chair").is_over());
}

TEST(TabularProduct, PropositionsThatTheModelLacksAreNamed) {
  try {
    task_on(square(), "F soffa");
    FAIL() << "accepted";
  } catch (const ltl::FormatError& error) {
    EXPECT_STREQ(error.what(), "the model has no proposition 'soffa' (did you mean 'sofa'?)");
  }
}

TEST(TabularProduct, GridsAreModelsToo) {
  const ltl::Vocabulary vocabulary({"goal"});
  const GridWorld grid({.width = 3, .height = 1}, vocabulary,
                       {{}, {.label = ltl::Letter{ltl::Proposition{0}}}}, {0, 0, 1}, 0);
  const TabularProduct product = compose(grid, tabulate(dfa_of("F goal"), grid.letters()));
  EXPECT_EQ(product.names, (std::vector<std::string>{"N", "E", "S", "W"}));
  EXPECT_EQ(product.outcomes_of(0, 1)[0].position, 1U);
  EXPECT_EQ(product.outcomes_of(0, 0)[0].position, 0U);
}

// What the step loop draws is what the tables say.
TEST(Environment, DrawsOutcomesWithTheirChances) {
  const Map map = plus();
  const PoseId centre = pose_at(map, 1, 1, 90);
  const TabularProduct product = task_on(map, "F (sofa & chair)", centre, slippery);
  ltl::Random random(4);
  Environment environment(product, 1000, random);
  std::map<std::uint32_t, int> drawn;
  constexpr int draws = 20'000;
  for (int i = 0; i < draws; ++i) {
    environment.reset();
    ++drawn[environment.step(0).position];
  }
  EXPECT_NEAR(drawn[pose_at(map, 2, 1, 90).index], 0.7 * draws, 300);
  EXPECT_NEAR(drawn[pose_at(map, 0, 1, 90).index], 0.05 * draws, 150);
}

TEST(Environment, CutsEpisodesAtTheHorizonAndEndsThemWithTheTask) {
  const Map map = hallway(2);
  const TabularProduct product = task_on(map, "F chair", pose_at(map, 0, 0, 90));
  ltl::Random random(1);
  Environment environment(product, 2, random);
  EXPECT_FALSE(environment.step(1).is_last());
  const auto second = environment.step(1);
  EXPECT_TRUE(second.cut && second.ending == Ending::Open);
  environment.reset();
  EXPECT_EQ(environment.step(0).ending, Ending::Open);
  EXPECT_EQ(environment.step(0).ending, Ending::Accepting);
}

}  // namespace
}  // namespace waymark::plan
