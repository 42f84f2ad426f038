#include "libplan/solve/written_strategy.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/product/product.hpp"
#include "libplan/product/task_table.hpp"
#include "libplan/solve/decide.hpp"

namespace waymark::plan {
namespace {

// Three rooms in a row; the way back costs 2, and `b` is read on the way into the last.
Mdp rooms() {
  MdpBuilder builder(ltl::Vocabulary({"b"}));
  const LetterId none = builder.letter({}), b = builder.letter({ltl::Proposition{0}});
  builder.add_state("hall");
  builder.add_choice("on");
  builder.add_outcome(1, none);
  builder.add_state("kitchen");
  builder.add_choice("back", 2);
  builder.add_outcome(0, none);
  builder.add_choice("on");
  builder.add_outcome(2, b);
  builder.add_state("bedroom");
  builder.add_choice("back", 2);
  builder.add_outcome(1, none);
  return std::move(builder).build(0, none);
}

struct Searched {
  explicit Searched(const char* formula)
      : dfa(automata::ltlf_to_dfa(ltl::parse(formula, arena))), table(dfa, model.letters()) {
    answer = search(Product(model, table)).value();
  }
  Mdp model = rooms();
  ltl::Arena arena{model.letters().vocabulary()};
  automata::Dfa dfa;
  TaskTable table;
  SearchAnswer answer;
};

TEST(WrittenStrategy, RoutesHaveTheNamesOfTheModel) {
  const Searched searched("F (b & X F (!b & X X true))");
  const NamedRoute route = named(searched.model, searched.answer.route.value());
  EXPECT_EQ(route.places.front(), "hall");
  EXPECT_EQ(route.actions, (std::vector<std::string>{"on", "on", "back", "on", "back"}));
  EXPECT_EQ(route.places, (std::vector<std::string>{"hall", "kitchen", "bedroom", "kitchen", "bedroom", "kitchen"}));
  EXPECT_EQ(route.cost, 7);
}

TEST(WrittenStrategy, DecisionsAlongARouteSayWhatIsLeftOfTheTask) {
  const Searched searched("F (b & X F b)");
  const ChoiceRoute& route = searched.answer.route.value();
  const std::vector<Decision> made = decisions(searched.model, searched.table, route);
  ASSERT_EQ(made.size(), 4U);
  automata::StateId q = searched.dfa.next(searched.dfa.initial(), {});
  for (std::size_t i = 0; i < made.size(); ++i) {
    EXPECT_EQ(made[i].place, searched.model.name(route.places[i]));
    EXPECT_EQ(made[i].action, i == 2 ? "back" : "on");
    EXPECT_EQ(made[i].state, route.places[i]);
    EXPECT_EQ(made[i].choice, route.choices[i]);
    EXPECT_EQ(made[i].jump, Decision::no_jump);
    EXPECT_EQ(made[i].task, q.index) << i;
    q = searched.dfa.next(q, route.places[i + 1] == 2 ? ltl::Letter{ltl::Proposition{0}} : ltl::Letter{});
  }
}

// The automaton guesses when `b` begins to hold for ever; which of its states it goes to is told.
TEST(WrittenStrategy, JumpsSayWhichStateTheyLeadTo) {
  MdpBuilder builder(ltl::Vocabulary({"b"}));
  const LetterId none = builder.letter({}), b = builder.letter({ltl::Proposition{0}});
  builder.add_state("hall");
  for (const char* name : {"on", "quickly on", "slowly on"}) {
    builder.add_choice(name);
    builder.add_outcome(1, b);
  }
  builder.add_state("bedroom");
  for (const char* name : {"stay", "sleep", "rest"}) {
    builder.add_choice(name);
    builder.add_outcome(1, b);
  }
  const Mdp mdp = std::move(builder).build(0, none);
  ltl::Arena arena(mdp.letters().vocabulary());
  const TaskTable task(automata::ltl_to_ldba(ltl::parse("F G b", arena)), mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  const std::vector<Decision> made = decisions(*product, greatest_probability(*product)->strategy);
  std::size_t jumps = 0;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i].jump == Decision::no_jump) continue;
    ++jumps;
    EXPECT_EQ(made[i].action, "");
    bool there = false;  // the state it leads to is met in the same place
    for (const Decision& other : made) there = there || (other.place == made[i].place && other.task == made[i].jump);
    EXPECT_TRUE(there) << "jump to " << made[i].jump;
  }
  EXPECT_EQ(jumps, 1U);
}

TEST(ProductSearch, CountsWhatItLooksAt) {
  const Searched near("F b");
  EXPECT_EQ(near.answer.statistics.met, 3U) << "hall, kitchen, and the goal";
  EXPECT_EQ(near.answer.statistics.edges, 3U) << "one of the hall, two of the kitchen";
  const Searched never("F (b & X b)");
  EXPECT_FALSE(never.answer.route.has_value());
  EXPECT_EQ(never.answer.statistics.met, 3U) << "back in the kitchen, all of the task is left";
  EXPECT_EQ(never.answer.statistics.edges, 4U);
}

}  // namespace
}  // namespace waymark::plan
