// Tasks given as automata are worth what their formulas are, deterministic or not; discounted rewards by plain sweeps.
#include "libplan/solve/task_automaton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/case_task.hpp"
#include "libplan/solve/discounted.hpp"
#include "libplan/solve/discounted_sweeps.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

using waymark::testing::scaled;
using Query = CaseTask::Query;

// The formula's automata as files: nondeterministic with any marks, and deterministic parity.
std::vector<std::string> files_of(ltl::Formula f) {
  return {automata::write_hoa(automata::ltl_to_tgba(f)), automata::write_hoa(automata::ltl_to_dpa(f).automaton())};
}

void expect_same(const CaseAnswer& one, const CaseAnswer& other, const std::string& where) {
  ASSERT_NE(one.status, CaseAnswer::Status::Exhausted) << where;
  EXPECT_EQ(one.status, other.status) << where;
  if (std::isinf(one.value.middle()))
    EXPECT_EQ(one.value.middle(), other.value.middle()) << where;
  else
    EXPECT_NEAR(one.value.middle(), other.value.middle(), 4e-6 * std::max(1.0, one.value.middle())) << where;
}

TEST(GivenAutomaton, IsWorthWhatItsFormulaIs) {
  ltl::Random random(41);
  int nondeterministic = 0;
  for (int i = 0; i < scaled(120); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 5 + random.below(9), .atoms = 2});
    const PlanningCase model{"", testing::random_model(random, {.states = 4}), {}};
    nondeterministic += automata::is_deterministic(automata::ltl_to_tgba(f).transitions()) ? 0 : 1;
    for (Query query : {Query::MaxProbability, Query::MinProbability, Query::MinCost, Query::Discounted}) {
      const CaseTask task{.id = "", .formula = ltl::print(f), .logic = CaseTask::Logic::Ltl, .query = query};
      const CaseOptions options{.explain = false};
      const CaseAnswer expected = answer(model, task, options);
      for (const std::string& file : files_of(f))
        expect_same(expected, answer(model, task, read_given_automaton(file), options),
                    ltl::print(f) + ", " + std::string(name(query)) + "\n" + file + "on\n" +
                        testing::show(std::get<Mdp>(model.model)));
    }
  }
  EXPECT_GT(nondeterministic, scaled(10));
}

// The past of a state without nexts is read by an automaton on finite words.
TEST(TaskAutomaton, OfThePastIsWorthWhatTheFutureIs) {
  ltl::Random random(42);
  int some = 0;
  for (int i = 0; i < scaled(60); ++i) {
    const PlanningCase model{"", testing::random_model(random, {.states = 4}), {}};
    const auto value = [&](const char* formula) {
      const CaseTask task{"", formula, CaseTask::Logic::Ltl, Query::MaxProbability};
      return answer(model, task, {.explain = false}).value.middle();
    };
    const double past = value("!a U (!b & (a S b))");
    EXPECT_NEAR(past, value("!a U (b & !a & X (a & !b))"), 4e-6) << testing::show(std::get<Mdp>(model.model));
    some += past > 0 && past < 1 ? 1 : 0;
  }
  EXPECT_GT(some, 0);
}

TEST(GivenAutomaton, LassosAreThoseOfItsFormula) {
  ltl::Random random(42);
  int found = 0;
  for (int i = 0; i < scaled(60); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2});
    const PlanningCase model{"", testing::random_model(random, {.states = 4, .deterministic = true}), {}};
    const CaseTask task{.id = "", .formula = ltl::print(f), .query = Query::LeastLasso};
    const CaseAnswer expected = answer(model, task);
    for (const std::string& file : files_of(f)) {
      const CaseAnswer got = answer(model, task, read_given_automaton(file));
      EXPECT_EQ(got.status, expected.status) << ltl::print(f) << "\n" << file;
    }
    found += expected.status == CaseAnswer::Status::Solved ? 1 : 0;
  }
  EXPECT_GT(found, scaled(20));
}

TEST(GivenAutomaton, FiniteWordsGoTheSameWay) {
  ltl::Random random(43);
  for (int i = 0; i < scaled(60); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2});
    const PlanningCase model{
        "", testing::random_model(random, {.states = 4, .deterministic = random.below(2) == 0}), {}};
    const CaseTask task{.id = "", .formula = ltl::print(f), .logic = CaseTask::Logic::Ltlf, .query = Query::MinSteps};
    const GivenAutomaton given = read_given_automaton(automata::write_hoa(automata::ltlf_to_dfa(f)));
    expect_same(answer(model, task, CaseOptions{.explain = false}), answer(model, task, given),
                ltl::print(f) + " on\n" + testing::show(std::get<Mdp>(model.model)));
  }
}

TEST(GivenAutomaton, SaysWhyNothingIsAccepted) {
  const PlanningCase line = parse_case(R"({"format": "ltlgrid/1", "width": 2, "height": 1, "rows": ["sa"],
    "legend": {"s": {}, "a": {"props": ["a"]}}, "start": {"x": 0, "y": 0}})");
  ltl::Arena arena(testing::vocabulary_ab());
  const auto asked = [&](ltl::Formula f, Query query) {
    return answer(line, {.id = "", .formula = "", .query = query}, GivenAutomaton(automata::ltlf_to_dfa(f)));
  };
  const ltl::Formula never = ltl::eventually(arena.atom("b")), possible = ltl::eventually(arena.atom("a"));
  EXPECT_EQ(asked(never, Query::MinCost).reason, "no strategy is sure to be accepted by the automaton");
  EXPECT_EQ(asked(never, Query::MaxProbability).reason, "no strategy has a chance to be accepted by the automaton");
  EXPECT_EQ(asked(possible, Query::MinCost).reason, "");
}

TEST(GivenAutomaton, SaysWhatItCannotAnswer) {
  ltl::Arena arena(testing::vocabulary_ab());
  ltl::Random random(44);
  const PlanningCase model{"", testing::random_model(random, {.deterministic = true}), {}};
  const ltl::Formula f = ltl::eventually(arena.atom("a"));
  const GivenAutomaton infinite = automata::ltl_to_tgba(f), finite = automata::ltlf_to_dfa(f);
  EXPECT_THROW(answer(model, {.id = "", .formula = "", .query = Query::MinSteps}, infinite), std::invalid_argument);
  EXPECT_THROW(answer(model, {.id = "", .formula = "", .query = Query::LeastLasso}, finite), std::invalid_argument);
}

TEST(Discounted, AgreesWithPlainSweeps) {
  ltl::Random random(45);
  int some = 0;
  for (int i = 0; i < scaled(300); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 6 + random.below(9), .atoms = 2});
    const Mdp mdp = testing::random_model(random, {.states = 4});
    const automata::Dfa dfa = automata::ltlf_to_dfa(f);
    const double discount = 0.1 * static_cast<double>(1 + random.below(9));
    const TaskTable task(dfa, mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    const auto found = greatest_discounted(*product, discount);
    ASSERT_TRUE(found);
    const double expected = testing::Plainly(mdp, dfa).discounted(discount);
    const std::string where = ltl::print(f) + " on\n" + testing::show(mdp);
    EXPECT_LE(found->value.lower, expected + 1e-12) << where;
    EXPECT_GE(found->value.upper, expected - 1e-12) << where;
    EXPECT_LE(found->value.upper - found->value.lower, 1e-6) << where;
    EXPECT_NEAR(found->re_evaluated.middle(), expected, 2e-6) << where;
    some += expected > 0 && expected < 1 ? 1 : 0;
  }
  EXPECT_GT(some, scaled(30));
}

// One choice that succeeds with chance p: the expectation of γ^(T−1) is p / (1 − γ (1 − p)).
TEST(Discounted, BoundsHoldWhereLittleIsGainedInASweep) {
  for (const double p : {0.5, 0.01, 0.001}) {
    ltl::Arena arena(testing::vocabulary_ab());
    MdpBuilder builder(testing::vocabulary_ab());
    const LetterId none = builder.letter({}), goal = builder.letter({ltl::Proposition{0}});
    builder.add_state();
    builder.add_choice("try");
    builder.add_outcome(0, none, 1 - p);
    builder.add_outcome(1, goal, p);
    builder.add_state();
    builder.add_choice("stay");
    builder.add_outcome(1, goal);
    const Mdp mdp = std::move(builder).build(0, none);
    const TaskTable task(automata::ltlf_to_dfa(ltl::eventually(arena.atom("a"))), mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    for (const double discount : {0.5, 0.99, 0.999})
      for (const double tolerance : {1e-2, 1e-4}) {
        const double expected = p / (1 - discount * (1 - p));
        const auto found = greatest_discounted(*product, discount, {.tolerance = tolerance});
        ASSERT_TRUE(found);
        for (const Bounds& bounds : {found->value, found->re_evaluated}) {
          EXPECT_LE(bounds.lower, expected + 1e-12) << p << ' ' << discount << ' ' << tolerance;
          EXPECT_GE(bounds.upper, expected - 1e-12) << p << ' ' << discount << ' ' << tolerance;
          EXPECT_LE(bounds.upper - bounds.lower, tolerance) << p << ' ' << discount << ' ' << tolerance;
        }
      }
    for (const double discount : {0.0, 1.0, -0.5, 1.5})
      EXPECT_THROW(greatest_discounted(*product, discount), std::invalid_argument) << discount;
  }
}

TEST(Discounted, EndsWhenAskedToAndAfterSoManySweeps) {
  ltl::Arena arena(testing::vocabulary_ab());
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({}), goal = builder.letter({ltl::Proposition{0}});
  for (std::uint32_t s = 0; s < 2; ++s) {
    builder.add_state();
    builder.add_choice("go");
    if (s == 0) builder.add_outcome(0, none, 0.5);
    builder.add_outcome(1, goal, s == 0 ? 0.5 : 1);
  }
  const Mdp mdp = std::move(builder).build(0, none);
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::eventually(arena.atom("a")));
  const TaskTable task(dfa, mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  std::stop_source source;
  source.request_stop();
  EXPECT_TRUE(greatest_discounted(*product, 0.5));
  EXPECT_FALSE(greatest_discounted(*product, 0.5, {.stop = source.get_token()}));
  DiscountedSweeps sweeps(*product, 0.5);
  EXPECT_FALSE(sweeps.run(1e-12, {}, 3));
  EXPECT_EQ(sweeps.sweeps(), 3U);
  EXPECT_TRUE(sweeps.run(1e-12, {}));
}

// One move to the goal, worth 1 before it: a sweep that says so, and one that changes nothing.
TEST(Discounted, CountsSweeps) {
  ltl::Arena arena(testing::vocabulary_ab());
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({}), goal = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("go");
  builder.add_outcome(0, goal);
  const Mdp mdp = std::move(builder).build(0, none);
  const TaskTable task(automata::ltlf_to_dfa(ltl::eventually(arena.atom("a"))), mdp.letters());
  const auto found = greatest_discounted(*ProductMdp<Mdp>::explore(mdp, task), 0.5);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->sweeps, 2U);
  EXPECT_EQ(found->value.lower, 1);
}

// The goal at once, with some chance: of choices that are worth the same but for the slack the first is taken.
TEST(Discounted, TheFirstOfTheBestChoicesUpToASlack) {
  ltl::Arena arena(testing::vocabulary_ab());
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId none = builder.letter({}), goal = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  for (const double chance : {0.5, 0.75, 0.75, 0.751}) {
    builder.add_choice("go");
    builder.add_outcome(1, goal, chance);
    builder.add_outcome(1, none, 1 - chance);
  }
  builder.add_state();
  builder.add_choice("stay");
  builder.add_outcome(1, none);
  const Mdp mdp = std::move(builder).build(0, none);
  const TaskTable task(automata::ltlf_to_dfa(ltl::eventually(arena.atom("a"))), mdp.letters());
  const auto product = ProductMdp<Mdp>::explore(mdp, task);
  DiscountedSweeps sweeps(*product, 0.5);
  ASSERT_TRUE(sweeps.run(1e-12, {}));
  const auto start = product->state(product->starts().front());
  EXPECT_EQ(sweeps.best(start).choice, 3U);
  EXPECT_EQ(sweeps.best(start, 1e-4).choice, 3U);
  EXPECT_EQ(sweeps.best(start, 0.01).choice, 1U);
}

}  // namespace
}  // namespace waymark::plan
