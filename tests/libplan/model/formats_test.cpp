// Formats of other tools' models: read or written, against models made by hand and the values of tasks.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/formats/read_transition_system.hpp"
#include "libplan/model/formats/write_jani.hpp"
#include "libplan/model/prism/write_prism.hpp"
#include "libplan/product/explicit_product.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tests/libplan/model/models.hpp"

namespace waymark::plan {
namespace {

using test::difference;

constexpr const char* two_models = R"(state_dim: [region, load]
state_models:
  region:
    ts_type: 2d_pose_region
    initial: r1
    nodes:
      r1: {attr: {type: square, pose: [[0, 0], [0]]}, connected_to: {r2: goto_r2}}
      r2: {connected_to: {r1: goto_r1}}
  load:
    initial: empty
    nodes:
      empty: {connected_to: {full: pick}}
      full: {connected_to: {empty: drop}}
actions:
  goto_r1: {type: move, weight: 10}
  goto_r2: {type: move, weight: 4}
  pick: {weight: 1, guard: r2}
  drop: {weight: 2.5, guard: "r1 && !empty"}
)";

TEST(TransitionSystem, IsTheProductOfItsModels) {
  MdpBuilder builder{ltl::Vocabulary({"r1", "r2", "empty", "full"})};
  const auto letter = [&](std::uint32_t region, std::uint32_t load) { return builder.letter({{region}, {load}}); };
  builder.add_state("r1,empty");
  builder.add_choice("goto_r2", 4);
  builder.add_outcome(1, letter(1, 2));
  builder.add_state("r2,empty");
  builder.add_choice("goto_r1", 10);
  builder.add_outcome(0, letter(0, 2));
  builder.add_choice("pick", 1);
  builder.add_outcome(2, letter(1, 3));
  builder.add_state("r2,full");
  builder.add_choice("goto_r1", 10);
  builder.add_outcome(3, letter(0, 3));
  builder.add_state("r1,full");
  builder.add_choice("goto_r2", 4);
  builder.add_outcome(2, letter(1, 3));
  builder.add_choice("drop", 2.5);
  builder.add_outcome(0, letter(0, 2));
  const LetterId first = letter(0, 2);
  const Mdp wanted = std::move(builder).build(0, first);
  const Mdp read = parse_transition_system(two_models, "two.yaml");
  EXPECT_EQ(difference(wanted, read), "");
  for (std::uint32_t s = 0; s < wanted.states(); ++s) {
    EXPECT_EQ(read.name(s), wanted.name(s));
    for (std::uint32_t k = 0; k < wanted.choices(s); ++k) EXPECT_EQ(read.action(s, k), wanted.action(s, k));
  }
}

TEST(TransitionSystem, NamesThePlaceOfAnError) {
  struct Row {
    const char *from, *to, *message;
    std::size_t line;
  };
  const Row table[] = {
      {"initial: r1", "initial: r9", "there is no node 'r9'", 5},
      {"{r2: goto_r2}", "{r3: goto_r2}", "there is no node 'r3'", 7},
      {"{r2: goto_r2}", "{r2: fly}", "there is no action 'fly'", 7},
      {"weight: 10", "weight: heavy", "expected a weight", 15},
      {"guard: r2", "guard: F r2", "without temporal operators", 17},
      {"guard: r2", "guard: r7", "unknown proposition 'r7'", 17},
      {"state_dim: [region, load]", "state_dim: []", "expected a list", 1},
      {"actions:", "acts:", "expected a map with 'actions'", 1},
      {"{type: move, weight: 10}", "{type: move, weight: 10", "", 16},
  };
  for (const Row& row : table) {
    std::string text = two_models;
    text.replace(text.find(row.from), std::string(row.from).size(), row.to);
    try {
      parse_transition_system(text, "two.yaml");
      ADD_FAILURE() << row.to << " was read";
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what();
      EXPECT_EQ(error.line(), row.line) << error.what();
      EXPECT_GT(error.column(), 0U) << error.what();
    }
  }
}

// The members and types that version 1 of JANI demands, and the model that the document describes.
Mdp model_of(const nlohmann::json& jani) {
  EXPECT_EQ(jani.at("jani-version"), 1);
  EXPECT_EQ(jani.at("type"), "mdp");
  ltl::Vocabulary names;
  for (const auto& variable : jani.at("variables")) {
    EXPECT_TRUE(variable.at("transient").get<bool>());
    EXPECT_TRUE(variable.contains("initial-value"));
    if (variable.at("type") == "bool") names.add(variable.at("name").get<std::string>());
  }
  EXPECT_EQ(jani.at("automata").size(), 1U);
  const auto& automaton = jani.at("automata")[0];
  EXPECT_EQ(jani.at("system").at("elements")[0].at("automaton"), automaton.at("name"));
  EXPECT_EQ(jani.at("system").at("syncs").size(), jani.at("actions").size());
  MdpBuilder builder(names);
  std::map<std::string, std::uint32_t> number;
  std::vector<LetterId> letters;
  for (const auto& location : automaton.at("locations")) {
    number.emplace(location.at("name").get<std::string>(), static_cast<std::uint32_t>(number.size()));
    ltl::Letter letter;
    if (location.contains("transient-values"))
      for (const auto& value : location.at("transient-values")) {
        EXPECT_TRUE(value.at("value").get<bool>());
        letter.insert(*names.find(value.at("ref").get<std::string>()));
      }
    letters.push_back(builder.letter(letter));
  }
  const auto& edges = automaton.at("edges");
  std::size_t next = 0;
  for (const auto& location : automaton.at("locations")) {
    builder.add_state();
    for (; next < edges.size() && edges[next].at("location") == location.at("name"); ++next) {
      double cost = 0;
      for (const auto& destination : edges[next].at("destinations"))
        if (destination.contains("assignments")) {
          EXPECT_EQ(destination.at("assignments")[0].at("ref"), "cost");
          cost = destination.at("assignments")[0].at("value");
        }
      builder.add_choice(edges[next].at("action").get<std::string>(), cost);
      for (const auto& destination : edges[next].at("destinations")) {
        const std::uint32_t target = number.at(destination.at("location").get<std::string>());
        builder.add_outcome(
            target, letters[target],
            destination.contains("probability") ? destination.at("probability").at("exp").get<double>() : 1);
      }
    }
  }
  EXPECT_EQ(next, edges.size());
  const std::uint32_t initial = number.at(automaton.at("initial-locations")[0].get<std::string>());
  const LetterId first = letters[initial];
  return std::move(builder).build(initial, first);
}

TEST(Jani, DescribesTheModel) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const StateLabelled model = with_labels_on_states(test::random_mdp(random));
    ASSERT_EQ(difference(model_of(nlohmann::json::parse(write_jani(model, "random"))), model.mdp), "") << i;
    const StateLabelled grid = with_labels_on_states(test::random_grid(random));
    ASSERT_EQ(difference(model_of(nlohmann::json::parse(write_jani(grid, "grid"))), grid.mdp), "") << i;
  }
}

TEST(Jani, AsksForTheTaskOfAProduct) {
  const Mdp model = parse_transition_system(two_models, "two.yaml");
  ltl::Arena arena(model.letters().vocabulary());
  const auto dfa = automata::ltlf_to_dfa(ltl::parse("F (full & F (r1 & empty))", arena));
  const TaskTable table(dfa, model.letters());
  const StateLabelled product = explicit_product(*ProductMdp<Mdp>::explore(model, table));
  const auto jani = nlohmann::json::parse(write_jani(product, "product"));
  EXPECT_EQ(difference(model_of(jani), product.mdp), "");
  std::map<std::string, nlohmann::json> properties;
  for (const auto& property : jani.at("properties")) properties[property.at("name")] = property.at("expression");
  EXPECT_EQ(properties.at("pmax").at("values").at("op"), "Pmax");
  EXPECT_EQ(properties.at("mincost").at("values").at("reach"), "goal");
}

TEST(ExplicitProduct, HasTheCoordinatesOfAGrid) {
  const ltl::Vocabulary names({"a"});
  const GridWorld grid({.width = 3, .height = 2}, names, {{}, {.label = {ltl::Proposition{0}}}}, {0, 0, 0, 0, 0, 1}, 0);
  ltl::Arena arena(names);
  const auto dfa = automata::ltlf_to_dfa(ltl::parse("F a", arena));
  const TaskTable table(dfa, grid.letters());
  const StateLabelled product = explicit_product(*ProductMdp<GridWorld>::explore(grid, table));
  ASSERT_EQ(product.values.variables, (std::vector<std::string>{"x", "y", "task"}));
  std::map<std::pair<int, int>, std::string> seen;
  for (std::uint32_t s = 0; s < product.mdp.states(); ++s) {
    const std::int32_t* values = product.values.values.data() + std::size_t{3} * s;
    seen[{values[0], values[1]}] = product.mdp.name(s);
  }
  ASSERT_EQ(seen.size(), 6U);
  for (std::int32_t y = 0; y < 2; ++y)
    for (std::int32_t x = 0; x < 3; ++x) {
      const std::string place = grid.name(static_cast<std::uint32_t>(3 * y + x));
      EXPECT_TRUE((seen[{x, y}].starts_with(place + " · "))) << seen[{x, y}] << ", not " << place;
    }
}

// Where the automaton may begin in several ways, a state before all others guesses at no cost; -2 marks its variables.
TEST(ExplicitProduct, GuessesHowTheAutomatonBegins) {
  std::mt19937 random(21);
  std::size_t guessed = 0, jumps = 0;
  for (const char* formula : {"F G a", "G F a | F G b", "F G a | F G b", "(F G a & G F b) | F G !b"})
    for (int i = 0; i < 5; ++i) {
      const Mdp model = test::random_mdp(random);
      ltl::Arena arena(model.letters().vocabulary());
      const automata::MdpSafe ldba = automata::ltl_to_ldba(ltl::parse(formula, arena));
      const TaskTable table(ldba, model.letters());
      const auto product = ProductMdp<Mdp>::explore(model, table);
      if (product->starts().size() < 2) continue;
      ++guessed;
      const StateLabelled unfolded = explicit_product(*product);
      const Mdp& mdp = unfolded.mdp;
      EXPECT_EQ(mdp.name(0), "start");
      ASSERT_EQ(mdp.choices(0), product->starts().size());
      for (std::uint32_t k = 0; k < mdp.choices(0); ++k) {
        EXPECT_EQ(mdp.action(0, k), "guess_" + std::to_string(k));
        EXPECT_EQ(mdp.cost(0, k), 0);
      }
      const std::size_t variables = unfolded.values.variables.size();
      ASSERT_EQ(unfolded.values.values.size(), variables * mdp.states());
      EXPECT_EQ(unfolded.values.values[0], -2);
      for (std::uint32_t s = 1; s < mdp.states(); ++s) {
        EXPECT_GE(unfolded.values.values[s * variables], -1);
        for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
          if (mdp.action(s, k) == "jump") {
            EXPECT_EQ(mdp.cost(s, k), 0) << "a jump takes no time";
            ++jumps;
          }
        }
      }
    }
  EXPECT_GT(guessed, 0U);
  EXPECT_GT(jumps, 0U);
}

// A state without choices stays where it is, at no cost: PRISM knows no ends of runs.
TEST(ExplicitProduct, StaysAtNoCostWhereNothingIsChosen) {
  MdpBuilder builder(ltl::Vocabulary({"a"}));
  const LetterId none = builder.letter({});
  builder.add_state();
  builder.add_choice("on", 3);
  builder.add_outcome(1, none);
  builder.add_state();
  const Mdp model = std::move(builder).build(0, none);
  ltl::Arena arena(model.letters().vocabulary());
  const auto dfa = automata::ltlf_to_dfa(ltl::parse("F a", arena));
  const TaskTable table(dfa, model.letters());
  const Mdp product = explicit_product(*ProductMdp<Mdp>::explore(model, table)).mdp;
  std::size_t stays = 0;
  for (std::uint32_t s = 0; s < product.states(); ++s)
    for (std::uint32_t k = 0; k < product.choices(s); ++k) {
      EXPECT_EQ(product.cost(s, k), product.action(s, k) == "stay" ? 0 : 3);
      stays += product.action(s, k) == "stay" ? 1 : 0;
    }
  EXPECT_GE(stays, 1U);
}

}  // namespace
}  // namespace waymark::plan
