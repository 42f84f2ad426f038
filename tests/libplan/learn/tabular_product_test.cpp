#include "libplan/learn/tabular_product.hpp"

#include <gtest/gtest.h>

#include <boost/range/iterator_range.hpp>
#include <map>

#include "libltl/diagnostic.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/print.hpp"
#include "libplan/learn/environment.hpp"
#include "libplan/product/compose.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/product/task_steps.hpp"
#include "tests/libplan/learn/tasks.hpp"
#include "tests/libplan/solve/random_models.hpp"

namespace waymark::plan {
namespace {

TEST(TabularProduct, IsTheBuiltProductWhereThatIsReachable) {
  for (const Map& map : {hallway(3), square(), plus(), shipped("l")})
    for (const char* formula : {"F (sofa & X F chair)", "!blue U chair", "F sofa & G !turned_left", "X X moved"}) {
      const automata::Dfa dfa = dfa_of(formula);
      const MapProduct built = compose(map, dfa, PoseId{0});
      const TabularProduct flat = tabulate(map, dfa, PoseId{0});
      ASSERT_EQ(flat.names, (std::vector<std::string>{"FORWARD", "LEFT", "RIGHT"}));
      EXPECT_TRUE(flat.is_deterministic());
      const auto number = [&](const ProductState& s) { return flat.state(s.place, s.task); };
      ASSERT_EQ(flat.starts.size(), 1U);
      EXPECT_EQ(flat.starts[0].state, number(built.starts()[0]));
      for (const ProductState& from : boost::make_iterator_range(vertices(built))) {
        EXPECT_EQ(flat.ending(number(from)) == Ending::Accepting, built.is_accepting(from));
        EXPECT_EQ(flat.ending(number(from)) == Ending::Trap, built.is_trap(from));
        for (auto [e, end] = out_edges(from, built); e != end; ++e) {
          const auto action = static_cast<std::uint32_t>(built.action(*e));
          const auto outcomes = flat.outcomes_of(from.place, action);
          ASSERT_EQ(outcomes.size(), 1U);
          EXPECT_EQ(flat.state(outcomes[0].position, flat.task.after(from.task, outcomes[0].letter)),
                    number(target(*e, built)))
              << map.name() << "  " << formula;
        }
      }
    }
}

// Learners and solvers meet the same chances: pair by pair of the product that the solvers explore.
TEST(TabularProduct, IsTheProductOfTheSolvers) {
  constexpr std::uint64_t seed = 16;
  ltl::Random random(seed);
  std::size_t compared = 0;
  for (int i = 0; i < 2'000; ++i) {
    const Mdp mdp = testing::random_model(random, {.states = 5, .unit_costs = false});
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2});
    const std::string what = ltl::print(f) + ", seed " + std::to_string(seed) + ", model " + std::to_string(i);
    const automata::Dfa dfa = automata::ltlf_to_dfa(f);
    const TaskTable task(dfa, mdp.letters());
    const TabularProduct flat = compose(mdp, tabulate(dfa, mdp.letters()));
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    ASSERT_TRUE(product);
    if (product->starts().empty()) continue;
    const auto number = [&](const auto& s) { return flat.state(s.place, task.origin(s.task)); };
    EXPECT_EQ(flat.starts[0].state, number(product->state(product->starts()[0]))) << what;
    product->for_each_state([&](const auto& s) {
      EXPECT_EQ(flat.ending(number(s)) == Ending::Accepting, product->is_goal(s)) << what;
      std::uint32_t action = 0;
      for (std::uint32_t k = 0; k < product->choices(s);
           ++k, ++action) {  // actions are offered in the order of choices
        while (!flat.is_offered(s.place, action)) ++action;
        std::map<std::uint32_t, double> solved, learnt;
        product->for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
          solved[t == ProductMdp<Mdp>::trap ? UINT32_MAX : number(product->state(t))] += p;
        });
        double before = 0;
        for (const auto& o : flat.outcomes_of(s.place, action)) {
          const std::uint32_t next = flat.state(o.position, flat.task.after(task.origin(s.task), o.letter));
          learnt[flat.ending(next) == Ending::Trap ? UINT32_MAX : next] += o.up_to - before;
          before = o.up_to;
        }
        EXPECT_EQ(flat.cost[s.place * flat.actions + action], product->cost(s, k)) << what;
        ASSERT_EQ(solved.size(), learnt.size()) << what;
        for (const auto& [t, p] : solved) EXPECT_NEAR(learnt[t], p, 1e-12) << what;
        ++compared;
      }
    });
  }
  EXPECT_GT(compared, 1000U);
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
  std::map<std::uint32_t, double> qualitative;
  for (const auto& o : product.outcomes_of(centre.index, 0)) {
    qualitative[o.position] += o.up_to - before;
    before = o.up_to;
  }
  EXPECT_EQ(before, 1);
  EXPECT_NEAR(qualitative[pose_at(map, 2, 1, 90).index], 0.7, 1e-12);
  EXPECT_NEAR(qualitative[pose_at(map, 1, 0, 90).index], 0.1, 1e-12);
  EXPECT_NEAR(qualitative[pose_at(map, 1, 2, 90).index], 0.15, 1e-12);
  EXPECT_NEAR(qualitative[pose_at(map, 0, 1, 90).index], 0.05, 1e-12);
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
  const GridWorld grid({.width = 3, .height = 1}, vocabulary, {{}, {.label = ltl::Letter{ltl::Proposition{0}}}},
                       {0, 0, 1}, 0);
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
