// JANI: the models and answers of the same programs in the language of PRISM; small documents by hand.
#include "libplan/model/jani/read_jani.hpp"

#include <gtest/gtest.h>

#include <random>

#include "libplan/model/formats/jani_properties.hpp"
#include "libplan/model/formats/write_jani.hpp"
#include "libplan/solve/finite_horizon.hpp"
#include "libplan/solve/property_answer.hpp"
#include "tests/libplan/model/models.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/two_languages.hpp"

namespace waymark::plan {
namespace {

using test::difference;

double value(const PrismProperty& p) {
  const Mdp& mdp = std::get<Mdp>(p.model->model);
  if (p.steps) return *expected_cost(mdp, {*p.steps, p.instantaneous, p.task.query == CaseTask::Query::MaxCost});
  return answer(*p.model, p.task, {.tolerance = 1e-9, .explain = false}).value.middle();
}

TEST(Jani, IsTheProgramThatPrismHas) {
  std::mt19937 random(11);
  std::size_t states = 0;
  for (int i = 0; i < 500; ++i) {
    const auto program = waymark::testing::random_program(random);
    const PrismOptions options{{{"k", std::to_string(i % 3)}}, ""};
    const Mdp prism = parse_prism(program.prism, "", {.states = 100}, options),
              jani = parse_jani(program.jani, "", {.states = 100}, options);
    ASSERT_EQ(difference(prism, jani), "") << program.prism << program.jani;
    for (std::uint32_t s = 0; s < prism.states(); ++s) {
      ASSERT_EQ(prism.name(s), jani.name(s)) << program.prism << program.jani;
      for (std::uint32_t k = 0; k < prism.choices(s); ++k) ASSERT_EQ(prism.action(s, k), jani.action(s, k));
    }
    states += prism.states();
  }
  EXPECT_GT(states, 5'000U);
}

TEST(Jani, HasTheAnswersThatPrismHas) {
  std::mt19937 random(12);
  for (int i = 0; i < (::waymark::testing::sanitized ? 50 : 500); ++i) {
    const auto program = waymark::testing::random_program(random);
    const PrismConstants constants{{"k", std::to_string(i % 3)}};
    const auto prism = parse_prism_properties({program.prism, ""}, {program.properties, ""}, constants);
    const auto jani = parse_jani_properties({program.jani, ""}, constants);
    ASSERT_EQ(prism.size(), jani.size());
    for (std::size_t p = 0; p < prism.size(); ++p) {
      ASSERT_EQ(prism[p].fault + jani[p].fault, "") << program.properties;
      EXPECT_EQ(prism[p].comparison, jani[p].comparison);
      EXPECT_EQ(prism[p].bound, jani[p].bound);
      const double a = value(prism[p]), b = value(jani[p]);
      if (a == b) continue;  // infinite costs too
      EXPECT_NEAR(a, b, 1e-7 * std::max(1.0, a)) << prism[p].text << '\n' << program.prism << program.jani;
    }
  }
}

TEST(Jani, ReadsWhatItWroteOfRandomModels) {
  std::mt19937 random(13);
  for (int i = 0; i < 200; ++i) {
    const StateLabelled labelled = with_labels_on_states(test::random_mdp(random));
    const std::string text = write_jani(labelled, "model");
    EXPECT_EQ(difference(parse_jani(text), labelled.mdp), "") << text;
  }
}

std::string document(const std::string& rest) { return R"({"jani-version":1,"name":"m","type":"mdp",)" + rest + "}"; }

// Two cups that swap at once, one round after the other, or each over what the other has become.
TEST(Jani, MakesAssignmentsInRounds) {
  const auto after = [](const std::string& assignments) {
    return parse_jani(document(R"("variables":[{"name":"x","type":"int","initial-value":1},)"
                               R"({"name":"y","type":"int","initial-value":2},)"
                               R"({"name":"t","type":"int","transient":true,"initial-value":10}],)"
                               R"("automata":[{"name":"a","locations":[{"name":"l"},{"name":"m"}],)"
                               R"("initial-locations":["l"],"edges":[{"location":"l","destinations":[{"location":"m",)"
                               R"("assignments":[)" +
                               assignments + R"(]}]}]}],"system":{"elements":[{"automaton":"a"}]})"))
        .name(1);
  };
  EXPECT_EQ(after(R"({"ref":"x","value":"y"},{"ref":"y","value":"x"})"), "2,1,1");
  EXPECT_EQ(after(R"({"ref":"x","value":"y"},{"ref":"y","value":"x","index":1})"), "2,2,1");
  EXPECT_EQ(after(R"({"ref":"x","value":"y","index":3},{"ref":"y","value":"x","index":1})"), "1,1,1");
  EXPECT_EQ(after(R"({"ref":"t","value":{"op":"+","left":"t","right":"x"}},{"ref":"y","value":"t","index":1},)"
                  R"({"ref":"x","value":"t"})"),
            "10,11,1");
}

// A sender and two receivers of one kind, each with a variable of its own; the sender names whom it serves.
constexpr const char* senders = R"("actions":[{"name":"send"},{"name":"get"},{"name":"done"}],
  "functions":[{"name":"twice","type":"int","parameters":[{"name":"n","type":"int"}],
                "body":{"op":"*","left":"n","right":2}}],
  "variables":[{"name":"busy","type":"bool","transient":true,"initial-value":false},
               {"name":"fee","type":"real","transient":true,"initial-value":0},
               {"name":"sent","type":{"kind":"bounded","base":"int","lower-bound":0,"upper-bound":9}}],
  "restrict-initial":{"exp":{"op":"=","left":"sent","right":{"op":"call","function":"twice","args":[1]}}},
  "automata":[
   {"name":"sender","locations":[{"name":"idle"},{"name":"on","transient-values":[{"ref":"busy","value":true},
      {"ref":"fee","value":{"op":"call","function":"twice","args":["sent"]}}]}],
    "initial-locations":["idle"],
    "edges":[{"location":"idle","action":"send","guard":{"exp":{"op":"<","left":"sent","right":6}},
              "destinations":[{"location":"on",
               "assignments":[{"ref":"sent","value":{"op":"+","left":"sent","right":1}},{"ref":"fee","value":5}]}]},
             {"location":"on","guard":{"exp":"busy"},"destinations":[{"location":"idle"}]}]},
   {"name":"receiver","variables":[{"name":"got","type":"int","initial-value":0}],
    "locations":[{"name":"l"}],"initial-locations":["l"],
    "edges":[{"location":"l","action":"get","guard":{"exp":{"op":"<","left":"got","right":1}},
              "destinations":[{"location":"l","probability":{"exp":0.5},
                               "assignments":[{"ref":"got","value":{"op":"+","left":"got","right":1}}]},
                              {"location":"l","probability":{"exp":0.5}}]}]}],
  "system":{"elements":[{"automaton":"sender"},{"automaton":"receiver"},{"automaton":"receiver"}],
            "syncs":[{"synchronise":["send","get",null],"result":"done"},{"synchronise":["send",null,"get"]}]})";

TEST(Jani, ComposesByVectors) {
  const Mdp mdp = parse_jani(document(senders));
  EXPECT_EQ(mdp.name(0), "2,0,0,0");
  ASSERT_EQ(mdp.choices(0), 2U);
  EXPECT_EQ(mdp.action(0, 0), "done");
  EXPECT_EQ(mdp.action(0, 1), "");
  EXPECT_EQ(mdp.name(mdp.outcome(0, 0, 0).target), "3,1,1,0");
  EXPECT_EQ(mdp.name(mdp.outcome(0, 0, 1).target), "3,1,0,0");
  EXPECT_EQ(mdp.name(mdp.outcome(0, 1, 0).target), "3,1,0,1");
  EXPECT_EQ(mdp.cost(0, 0), 5);                                // assigned on the step
  EXPECT_EQ(mdp.cost(mdp.outcome(0, 0, 0).target, 0), 2 * 3);  // of the location
  const ltl::Proposition busy = *mdp.letters().vocabulary().find("busy");
  EXPECT_FALSE(mdp.letters()[mdp.initial_letter()].contains(busy));
  EXPECT_TRUE(mdp.letters()[mdp.outcome(0, 0, 0).letter].contains(busy));
}

TEST(Jani, ReadsEveryOperator) {
  const struct {
    std::string condition;
    bool holds;  // with x = 3, b true
  } rows[] = {
      {R"({"op":"∨","left":false,"right":"b"})", true},
      {R"({"op":"∧","left":false,"right":"b"})", false},
      {R"({"op":"⇒","left":"b","right":false})", false},
      {R"({"op":"¬","exp":"b"})", false},
      {R"({"op":"=","left":"b","right":true})", true},
      {R"({"op":"≠","left":"x","right":3})", false},
      {R"({"op":"<","left":"x","right":3.5})", true},
      {R"({"op":"≤","left":"x","right":2})", false},
      {R"({"op":">","left":"x","right":2})", true},
      {R"({"op":"≥","left":"x","right":4})", false},
      {R"({"op":"=","left":{"op":"-","left":"x","right":1},"right":2})", true},
      {R"({"op":"=","left":{"op":"%","left":"x","right":2},"right":1})", true},
      {R"({"op":"=","left":{"op":"/","left":"x","right":2},"right":1.5})", true},
      {R"({"op":"=","left":{"op":"pow","left":"x","right":2},"right":9})", true},
      {R"({"op":"=","left":{"op":"log","left":8,"right":2},"right":"x"})", true},
      {R"({"op":"=","left":{"op":"floor","exp":-0.5},"right":-1})", true},
      {R"({"op":"=","left":{"op":"ceil","exp":-0.5},"right":0})", true},
      {R"({"op":"=","left":{"op":"trc","exp":-1.5},"right":-1})", true},
      {R"({"op":"=","left":{"op":"abs","exp":-2},"right":2})", true},
      {R"({"op":"=","left":{"op":"sgn","exp":-2},"right":-1})", true},
      {R"({"op":"=","left":{"op":"min","left":"x","right":7},"right":{"op":"max","left":1,"right":"x"}})", true},
      {R"({"op":"=","left":{"op":"ite","if":"b","then":1,"else":2},"right":1})", true},
      {R"({"op":"<","left":{"constant":"e"},"right":{"constant":"π"}})", true}};
  for (const auto& row : rows) {
    const Mdp mdp = parse_jani(
        document(R"("variables":[{"name":"x","type":"int","initial-value":3},)"
                 R"({"name":"b","type":"bool","initial-value":true}],)"
                 R"("automata":[{"name":"a","locations":[{"name":"l"},{"name":"m"}],"initial-locations":["l"],)"
                 R"("edges":[{"location":"l","guard":{"exp":)" +
                 row.condition + R"(},"destinations":[{"location":"m"}]}]}],)" +
                 R"("system":{"elements":[{"automaton":"a"}]})"));
    EXPECT_EQ(mdp.states() == 2, row.holds) << row.condition;
  }
}

TEST(Jani, AsksInManyForms) {
  const auto asked = [](const std::string& expression) {
    const auto found = parse_jani_properties(
        {document(senders + std::string(R"(,"properties":[{"name":"p","expression":)") + expression + "}]"), ""});
    return found.at(0);
  };
  const std::string sent = R"({"op":"=","left":"sent","right":4})";
  EXPECT_NEAR(value(asked(R"({"op":"Pmax","exp":{"op":"F","exp":)" + sent + "}}")), 1, 1e-6);
  // Two sends cost 5 each, the location between them twice the number that was sent.
  EXPECT_NEAR(value(asked(R"({"op":"Emin","exp":"fee","accumulate":["steps"],"reach":)" + sent + "}")), 10, 1e-6);
  EXPECT_NEAR(value(asked(R"({"op":"Emin","exp":"fee","accumulate":["exit","steps"],"reach":)" + sent + "}")), 16,
              1e-6);
  EXPECT_NEAR(value(asked(R"({"op":"Emax","exp":1,"accumulate":["steps"],"reach":)" + sent + "}")), 3, 1e-6);
  EXPECT_NEAR(value(asked(R"({"op":"Emax","exp":"sent","step-instant":2})")), 3, 1e-6);
  // For ever: until both receivers have got one, each by half a chance, at most four sends: 5 (2/4 + 3/4 + 4/2).
  EXPECT_NEAR(answer(asked(R"({"op":"Emax","exp":"fee","accumulate":["steps"]})"), {}).answer.value.middle(), 16.25,
              1e-4);
  EXPECT_EQ(asked(R"({"op":">","left":0.25,"right":{"op":"Pmin","exp":{"op":"G","exp":"busy"}}})").comparison, "<");
  const std::pair<std::string, std::string> faults[] = {
      {R"({"op":"filter","fun":"min","states":{"op":"deadlock"},"values":{"op":"Pmax","exp":"busy"}})",
       "a filter over other states than the initial ones"},
      {R"({"op":"filter","fun":"count","states":{"op":"initial"},"values":{"op":"Pmax","exp":"busy"}})",
       "a filter that asks for count"},
      {R"({"op":"∀","exp":{"op":"F","exp":"busy"}})", "this is no Pmin, Pmax, Emin or Emax"},
      {R"({"op":"Emin","exp":"fee","accumulate":["time"],"reach":"busy"})", "rewards of time"},
      {R"({"op":"Emin","exp":"fee","accumulate":["steps"],"step-instant":-1})",
       "a bound on steps outside of [0, 10^9]"},
      {R"({"op":"Pmax","exp":{"op":"F","exp":"none"}})",
       "properties[0].expression.exp.exp: there is no variable or constant 'none'"}};
  for (const auto& [expression, fault] : faults) EXPECT_EQ(asked(expression).fault, fault);
}

}  // namespace
}  // namespace waymark::plan
