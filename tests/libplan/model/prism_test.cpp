// Models written for PRISM and read again; the planning cases in PRISM's language against those in JSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>

#include "libltl/text/parse.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/model/prism/read_prism.hpp"
#include "libplan/model/prism/read_prism_explicit.hpp"
#include "libplan/model/prism/write_prism.hpp"
#include "libplan/product/explicit_product.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tests/libplan/model/models.hpp"
#include "tests/support/places.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

namespace fs = std::filesystem;
using test::difference;

PrismFiles files(const PrismExplicit& written) {
  PrismFiles out{written.transitions, written.labels, written.states};
  (written.rewards_on_states ? out.state_rewards : out.transition_rewards) = written.rewards;
  return out;
}

std::vector<CaseTask> probing_tasks() {
  using Query = CaseTask::Query;
  using Logic = CaseTask::Logic;
  return {{"reach", "F b", Logic::Ltl, Query::MaxProbability},
          {"late", "X X a", Logic::Ltl, Query::MaxProbability},
          {"avoid", "!a U b", Logic::Ltl, Query::MinProbability},
          {"patrol", "(G F a) & (G F b)", Logic::Ltl, Query::MaxProbability},
          {"cost", "F (b & X a)", Logic::Ltl, Query::MinCost}};
}

// The same proved values, up to the tolerance of both.
void expect_same_values(const PlanningCase& one, const PlanningCase& other, const std::vector<CaseTask>& tasks,
                        const std::string& model) {
  for (const CaseTask& task : tasks) {
    const CaseOptions options{.tolerance = 1e-8, .explain = false};
    const CaseAnswer a = answer(one, task, options), b = answer(other, task, options);
    ASSERT_EQ(a.status, b.status) << task.formula << " on\n" << model;
    if (a.value.lower == b.value.lower) continue;  // infinite costs too
    EXPECT_NEAR(a.value.middle(), b.value.middle(), 1e-7 * std::max(1.0, a.value.middle())) << task.formula << " on\n"
                                                                                            << model;
  }
}

TEST(Prism, ReadsWhatItWroteOfRandomModels) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Mdp mdp = test::random_mdp(random);
    const StateLabelled labelled = with_labels_on_states(mdp);
    const std::string text = write_prism(labelled);
    EXPECT_EQ(difference(parse_prism(text), labelled.mdp), "") << text;
    const PrismExplicit written = write_prism_explicit(labelled);
    EXPECT_EQ(difference(parse_prism_explicit(files(written)), labelled.mdp), "")
        << written.transitions << written.labels << written.rewards;
  }
}

// The rows of odd states first, or the states the other way round; those of one choice as they were.
std::string in_disorder(const std::string& transitions, bool odd_first) {
  std::istringstream in(transitions);
  std::string header, line;
  std::getline(in, header);
  std::vector<std::pair<int, std::string>> lines;
  while (std::getline(in, line)) {
    const int state = std::stoi(line);
    lines.emplace_back(odd_first ? 1 - state % 2 : -state, line);
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string out = header + '\n';
  for (const auto& [key, text] : lines) out += text + '\n';
  return out;
}

TEST(Prism, ReadsRowsInAnyOrder) {
  std::mt19937 random(5);
  std::size_t differ = 0;
  for (int i = 0; i < 200; ++i) {
    const StateLabelled labelled = with_labels_on_states(test::random_mdp(random));
    PrismFiles given = files(write_prism_explicit(labelled));
    const std::string sorted = given.transitions;
    for (const bool odd_first : {true, false}) {
      given.transitions = in_disorder(sorted, odd_first);
      differ += given.transitions == sorted ? 0 : 1;
      EXPECT_EQ(difference(parse_prism_explicit(given), labelled.mdp), "") << given.transitions;
    }
  }
  EXPECT_GT(differ, 200U);
}

TEST(Prism, ReadsWhatItWroteOfRandomGrids) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const GridWorld grid = test::random_grid(random);
    const std::string text = write_prism(grid);
    EXPECT_EQ(difference(parse_prism(text), with_labels_on_states(grid).mdp), "") << text;
  }
}

TEST(Prism, OperatorsBindAsInItsManual) {
  const auto model = [](const std::string& guard) {
    return parse_prism("mdp module m x : [0..3] init 0; [] x < 3 -> (x'=x+1); endmodule label \"b\" = " + guard + ";");
  };
  const std::array<std::array<std::string, 2>, 9> table{{
      {"x=1 | x=2 & x=3", "(x=1) | ((x=2) & (x=3))"},
      {"!x=1 & x=2", "(!(x=1)) & (x=2)"},
      {"!x=1 | x=1 => x=2", "((!(x=1)) | (x=1)) => (x=2)"},
      {"x=1 => x=2 => x=3", "((x=1) => (x=2)) => (x=3)"},
      {"x=1 <=> x=2 | x=0", "(x=1) <=> ((x=2) | (x=0))"},
      {"x=1 <=> x=2 => x=0", "((x=1) <=> (x=2)) => (x=0)"},
      {"1+x*2-x = x+1", "((1+(x*2))-x) = (x+1)"},
      {"x-1-1 < 1", "((x-1)-1) < 1"},
      {"x<1 = x<2", "(x<1) = (x<2)"},
  }};
  for (const auto& [bare, bracketed] : table) EXPECT_EQ(difference(model(bare), model(bracketed)), "") << bare;
}

TEST(Prism, KeepsTheValues) {
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    Mdp mdp = test::random_mdp(random);
    bool runs_end = false;  // a state without choices ends runs with us, and stays in PRISM
    for (std::uint32_t s = 0; s < mdp.states(); ++s) runs_end = runs_end || mdp.choices(s) == 0;
    if (runs_end) continue;
    const std::string text = write_prism(with_labels_on_states(mdp));
    expect_same_values({"", std::move(mdp), {}}, {"", parse_prism(text), {}}, probing_tasks(), text);
  }
  for (int i = 0; i < 40; ++i) {
    GridWorld grid = test::random_grid(random);
    const std::string text = write_prism(grid);
    const PrismFiles explicit_files = files(write_prism_explicit(with_labels_on_states(grid)));
    const PlanningCase one{"", std::move(grid), {}};
    expect_same_values(one, {"", parse_prism(text), {}}, probing_tasks(), text);
    expect_same_values(one, {"", parse_prism_explicit(explicit_files), {}}, probing_tasks(), text);
  }
}

TEST(Prism, SplitsAStateByTheLetterThatEntersIt) {
  MdpBuilder builder(ltl::Vocabulary({"a", "the easel", "F"}));
  const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}}),
                 easel = builder.letter({ltl::Proposition{1}, ltl::Proposition{2}});
  builder.add_state();
  builder.add_choice("E", 2);
  builder.add_outcome(1, a, 0.25);
  builder.add_outcome(1, easel, 0.75);
  builder.add_state();
  const PrismExplicit written = write_prism_explicit(with_labels_on_states(std::move(builder).build(0, none)));
  EXPECT_EQ(written.transitions, "3 3 4\n0 0 1 0.25 E_\n0 0 2 0.75 E_\n1 0 1 1 stay\n2 0 2 1 stay\n");
  EXPECT_EQ(written.states, "(s,letter)\n0:(0,0)\n1:(1,1)\n2:(1,2)\n");
  EXPECT_EQ(written.labels, "0=\"init\" 1=\"deadlock\" 2=\"a\" 3=\"the_easel\" 4=\"F_\"\n0: 0\n1: 2\n2: 3 4\n");
  EXPECT_EQ(written.rewards, "3 1\n0 2\n");
  EXPECT_TRUE(written.rewards_on_states);
}

// Pmax of the task is Pmax of reaching a goal, or of meeting marks for ever, on the product written out.
template <class Model>
void expect_same_value_on_the_product(const Model& model, const std::string& formula) {
  ltl::Arena arena(model.letters().vocabulary());
  const auto automaton =
      task_automaton(ltl::parse(formula, arena), CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability, {});
  ASSERT_TRUE(automaton);
  const bool finite = std::holds_alternative<automata::Dfa>(*automaton);
  const StateLabelled product = std::visit(
      [&](const auto& a) {
        const TaskTable table(a, model.letters());
        return explicit_product(*ProductMdp<Model>::explore(model, table));
      },
      *automaton);
  const std::string text = write_prism(product);
  const CaseTask task{"", formula, CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability};
  const CaseTask reach{"", finite ? "F goal" : "G F marked", CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability};
  const CaseOptions options{.tolerance = 1e-8, .explain = false};
  EXPECT_NEAR(answer({"", model, {}}, task, options).value.middle(),
              answer({"", parse_prism(text), {}}, reach, options).value.middle(), 1e-7)
      << formula << " on\n"
      << text;
}

TEST(Prism, HasTheValueOfTheTaskOnTheProduct) {
  std::mt19937 random(4);
  for (int i = 0; i < 15; ++i)
    for (const char* formula : {"F (a & X b)", "!a U b", "(G F a) & (G F b)", "F G a", "G !a", "(F G a) | (G F b)"}) {
      expect_same_value_on_the_product(test::random_mdp(random), formula);
      expect_same_value_on_the_product(test::random_grid(random), formula);
    }
}

// ---- the cases that come with values

fs::path cases() { return waymark::testing::shared() / "plan" / "cases"; }

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Prism, GivesTheValuesOfTheCases) {
  if (!fs::exists(cases())) GTEST_SKIP() << "no planning cases at " << cases();
  std::size_t models = 0;
  for (const auto& entry : fs::directory_iterator(cases())) {
    if (entry.path().extension() != ".nm") continue;
    if (models++ % (::waymark::testing::sanitized ? 4 : 1) != 0) continue;
    const PlanningCase json = read_case(fs::path(entry.path()).replace_extension(".json"));
    const PlanningCase prism{json.name, parse_prism(contents(entry.path()), entry.path().string()), {}};
    for (const CaseTask& task : json.tasks) {
      const CaseOptions options{.explain = false};
      const CaseAnswer a = answer(json, task, options), b = answer(prism, task, options);
      EXPECT_EQ(a.status, b.status) << json.name << ' ' << task.id;
      if (a.value.lower == b.value.lower && a.value.upper == b.value.upper) continue;
      EXPECT_NEAR(a.value.middle(), b.value.middle(), 2e-6 * std::max(1.0, a.value.middle()))
          << json.name << ' ' << task.id;
    }
  }
  EXPECT_GT(models, 0U);
}

}  // namespace
}  // namespace waymark::plan
