// Steady states, total rewards, nested operators and filters, against iteration over many steps and one another.
#include "libplan/solve/property_answer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "libplan/model/prism/write_prism.hpp"
#include "libplan/solve/long_run.hpp"
#include "libplan/solve/state_model.hpp"
#include "tests/libplan/model/models.hpp"

namespace waymark::plan {
namespace {

PropertyAnswer answered(const std::string& model, const std::string& property) {
  const std::vector<PrismProperty> all = parse_prism_properties({model, ""}, {property, ""});
  EXPECT_EQ(all.size(), 1U) << property;
  EXPECT_EQ(all.at(0).fault, "") << property;
  return answer(all.at(0), {.tolerance = 1e-8, .explain = false});
}
double number(const std::string& model, const std::string& property) {
  return answered(model, property).answer.value.middle();
}

// A random model; of a chain only the first choice of each state.
Mdp random_states(std::mt19937& random, bool chain) {
  const Mdp mdp = with_labels_on_states(test::random_mdp(random)).mdp;
  MdpBuilder builder(mdp.letters().vocabulary());
  for (std::uint32_t s = 0; s < mdp.states(); ++s) {
    builder.add_state();
    for (std::uint32_t k = 0; k < (chain ? 1 : mdp.choices(s)); ++k) {
      builder.add_choice(mdp.action(s, k), random() % 2 == 0 ? 0 : mdp.cost(s, k));
      for (const ModelOutcome& o : mdp.outcomes(s, k))
        builder.add_outcome(o.target, builder.letter(mdp.letters()[o.letter]), o.probability);
    }
  }
  const LetterId first = builder.letter(mdp.letters()[mdp.initial_letter()]);
  return std::move(builder).build(0, first);
}

// What `steps` steps from every state cost, by the choices that are best for it.
std::vector<double> costs_of_steps(const Mdp& mdp, std::size_t steps, bool greatest) {
  std::vector<double> now(mdp.states(), 0);
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<double> next(mdp.states(), 0);
    for (std::uint32_t s = 0; s < mdp.states(); ++s)
      for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
        double sum = mdp.cost(s, k);
        for (const ModelOutcome& o : mdp.outcomes(s, k)) sum += o.probability * now[o.target];
        next[s] = k == 0 ? sum : greatest ? std::max(next[s], sum) : std::min(next[s], sum);
      }
    now = next;
  }
  return now;
}

TEST(LongRun, IsTheMeanOfManySteps) {
  std::mt19937 random(21);
  constexpr std::size_t steps = 20'000;
  for (int i = 0; i < 200; ++i) {
    const Mdp chain = random_states(random, true);
    std::vector<double> costs(chain.states());
    for (std::uint32_t s = 0; s < chain.states(); ++s) costs[s] = chain.cost(s, 0);
    const auto found = long_run(chain, costs);
    ASSERT_TRUE(found);
    const std::vector<double> sums = costs_of_steps(chain, steps, true);
    for (std::uint32_t s = 0; s < chain.states(); ++s) EXPECT_NEAR((*found)[s], sums[s] / steps, 0.02) << i;
  }
}

TEST(LongRun, IsRefusedWhereThereIsAChoice) {
  for (std::uint32_t where = 0; where < 4; ++where) {
    MdpBuilder builder(ltl::Vocabulary({"a"}));
    const LetterId none = builder.letter({});
    for (std::uint32_t s = 0; s < 3; ++s) {
      builder.add_state();
      for (std::uint32_t k = 0; k < (s == where ? 2 : 1); ++k) {
        builder.add_choice("on");
        builder.add_outcome((s + 1) % 3, none);
      }
    }
    const Mdp mdp = std::move(builder).build(0, none);
    if (where < 3)
      EXPECT_THROW(long_run(mdp, {1, 2, 3}), std::invalid_argument) << where;
    else
      EXPECT_NEAR(long_run(mdp, {1, 2, 3}).value()[1], 2, 1e-12);
  }
}

TEST(PropertyAnswer, OfTotalRewardsIsTheLimitOfManySteps) {
  std::mt19937 random(22);
  std::size_t finite = 0, infinite = 0;
  for (int i = 0; i < 300; ++i) {
    const Mdp mdp = random_states(random, i % 4 == 0);
    for (const bool greatest : {false, true}) {
      PrismProperty p;
      p.ask = PrismProperty::Ask::Total;
      p.about_rewards = true;
      p.task.query = greatest ? CaseTask::Query::MaxCost : CaseTask::Query::MinCost;
      p.model = std::make_shared<const PlanningCase>(PlanningCase{"", mdp, {}});
      const double found = answer(p, {.tolerance = 1e-8, .explain = false}).answer.value.middle(),
                   sum = costs_of_steps(mdp, 20'000, greatest)[0];
      if (std::isinf(found)) {
        EXPECT_GT(sum, 100) << i;
        ++infinite;
      } else {
        EXPECT_NEAR(found, sum, 1e-5 * std::max(1.0, sum)) << i;
        ++finite;
      }
    }
  }
  EXPECT_GT(finite, 50U);
  EXPECT_GT(infinite, 50U);
}

// An operator inside is the label of the states where its filter holds.
TEST(PropertyAnswer, OfNestedOperatorsIsThatOfLabels) {
  std::mt19937 random(23);
  for (int i = 0; i < 60; ++i) {
    const StateLabelled labelled = with_labels_on_states(test::random_mdp(random));
    std::string model = write_prism(labelled);
    const std::string inside = "P>=0.4 [ F<=2 \"a\" ]";
    std::string where = "false";
    std::size_t count = 0;
    for (std::uint32_t s = 0; s < labelled.mdp.states(); ++s) {
      std::string at = "true";
      for (std::size_t v = 0; v < labelled.values.variables.size(); ++v)
        at += '&' + labelled.values.variables[v] + '=' +
              std::to_string(labelled.values.values[s * labelled.values.variables.size() + v]);
      const PropertyAnswer one = answered(model, "filter(state, " + inside + ", " + at + ")");
      ASSERT_TRUE(one.verdict);
      if (!*one.verdict) continue;
      where += "|(" + at + ')';
      ++count;
    }
    EXPECT_EQ(number(model, "filter(count, " + inside + ")"), static_cast<double>(count));
    for (const char* query : {"Pmax=? [ F (\"b\" & NESTED) ]", "Pmin=? [ X NESTED ]", "Pmax=? [ G F !NESTED ]",
                              "Pmin=? [ NESTED U \"b\" ]"}) {
      std::string one = query, other = query;
      one.replace(one.find("NESTED"), 6, inside);
      other.replace(other.find("NESTED"), 6, "(" + where + ")");
      EXPECT_NEAR(number(model, one), number(model, other), 1e-6) << one << '\n' << other << '\n' << model;
    }
  }
}

// By level of what is left, every state of a level by iteration: what is free stays on the level.
std::vector<double> within(const Mdp& mdp, const std::vector<bool>& goal, std::size_t budget, bool greatest) {
  std::vector<std::vector<double>> left;
  for (std::size_t b = 0; b <= budget; ++b) {
    std::vector<double> now(mdp.states(), 0);
    for (int sweep = 0; sweep < 3'000; ++sweep)
      for (std::uint32_t s = 0; s < mdp.states(); ++s) {
        double best = greatest ? 0 : 1;
        for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
          const auto cost = static_cast<std::size_t>(mdp.cost(s, k));
          double sum = 0;
          for (const ModelOutcome& o : mdp.outcomes(s, k))
            if (cost <= b) sum += o.probability * (cost == 0 ? now : left[b - cost])[o.target];
          best = greatest ? std::max(best, sum) : std::min(best, sum);
        }
        now[s] = goal[s] ? 1 : best;
      }
    left.push_back(now);
  }
  return left.back();
}

TEST(PropertyAnswer, OfBudgetsIsThatOfLevels) {
  std::mt19937 random(24);
  for (int i = 0; i < 40; ++i) {
    const Mdp free = random_states(random, i % 4 == 0);
    MdpBuilder builder(free.letters().vocabulary());
    std::vector<bool> goal(free.states(), false);
    const std::vector<LetterId> letters = letters_of_states(free);
    for (std::uint32_t s = 0; s < free.states(); ++s) {
      builder.add_state();
      goal[s] = free.letters()[letters[s]].contains(ltl::Proposition{0});
      for (std::uint32_t k = 0; k < free.choices(s); ++k) {
        builder.add_choice(free.action(s, k), static_cast<double>(random() % 3));
        for (const ModelOutcome& o : free.outcomes(s, k))
          builder.add_outcome(o.target, builder.letter(free.letters()[letters[o.target]]), o.probability);
      }
    }
    const LetterId first = builder.letter(free.letters()[letters[0]]);
    const Mdp mdp = std::move(builder).build(0, first);
    for (const std::size_t budget : {0U, 1U, 4U})
      for (const bool greatest : {true, false}) {
        PrismProperty p;
        p.budget = budget;
        p.task = {"", "F (" + mdp.letters().vocabulary().name(ltl::Proposition{0}) + " & \"within the budget\")",
                  CaseTask::Logic::Ltl, greatest ? CaseTask::Query::MaxProbability : CaseTask::Query::MinProbability};
        p.model = std::make_shared<const PlanningCase>(PlanningCase{"", mdp, {}});
        EXPECT_NEAR(answer(p, {.tolerance = 1e-8, .explain = false}).answer.value.middle(),
                    within(mdp, goal, budget, greatest)[0], 1e-6)
            << i << ' ' << budget << ' ' << greatest;
      }
  }
}

constexpr const char* coin = R"(dtmc
module m
  s : [0..4];
  [] s=0 -> 0.5:(s'=1) + 0.25:(s'=2) + 0.25:(s'=3);
  [] s=1 -> (s'=2);
  [] s=2 -> (s'=1);
  [] s=3 -> 0.75:true + 0.25:(s'=4);
  [] s=4 -> (s'=3);
endmodule
rewards "r" s=1 : 4; [] s=0 : 8; endrewards
)";

TEST(PropertyAnswer, KnowsFiltersAndTheLongRun) {
  const std::pair<const char*, double> numbers[] = {{"S=? [ s=1 ]", 3.0 / 8},
                                                    {"S=? [ s=3 ]", 0.25 * 4 / 5},
                                                    {"R{\"r\"}=? [ S ]", 1.5},
                                                    {"R{\"r\"}=? [ C ]", INFINITY},
                                                    {"filter(state, R{\"r\"}=? [ C ], s=4)", 0},
                                                    {"filter(min, P=? [ F s=1 ], s<3)", 0.75},
                                                    {"filter(max, P=? [ F s=4 ])", 1},
                                                    {"filter(avg, P=? [ F<=1 s=2 ], s=0 | s=1)", 0.625},
                                                    {"filter(sum, P=? [ X s=1 ])", 1.5},
                                                    {"filter(first, P=? [ X s=1 ], s>0)", 0},
                                                    {"filter(first, P=? [ F s=1 ], s>0)", 1},
                                                    {"filter(count, S>=0.5 [ s>0 & s<3 ])", 3},
                                                    {"filter(count, s>2 & P>=1 [ F s=3 ])", 2},
                                                    {"filter(count, P>=1 [ F s=3 ], s>4)", 0},
                                                    {"filter(range, P=? [ X s=1 ])", 0},
                                                    {"P=? [ X P>0.5 [ X s=1 ] ]", 0.25},
                                                    {"P=? [ F (S>=0.5 [ s=3 ] & filter(exists, s=4)) ]", 0.25}};
  for (const auto& [property, value] : numbers) {
    const double found = number(coin, property);
    if (std::isinf(value)) {
      EXPECT_EQ(found, value) << property;
    } else {
      EXPECT_NEAR(found, value, 1e-7) << property;
    }
  }
  EXPECT_EQ(answered(coin, "filter(range, P=? [ X s=1 ])").range->upper, 1);
  const std::pair<const char*, bool> truths[] = {{"s=0 & P>=0.75 [ F s=2 ]", true},
                                                 {"!(s=0) | P>=1 [ F s=3 ]", false},
                                                 {"filter(forall, P>=1 [ F s=3 ] => P<=0 [ F s=1 ])", true},
                                                 {"filter(exists, P<=0 [ F s=1 ], s<3)", false},
                                                 {"filter(exists, P>=1 [ F s=3 ], s>4)", false},
                                                 {"filter(forall, P>=1 [ F s=3 ], s>4)", true},
                                                 {"P>=1 [ G P>=0.25 [ X s!=0 ] ]", true},
                                                 {"P<1 [ F s>0 ]", false},
                                                 {"P<=1 [ F s>0 ]", true},
                                                 {"P>1 [ F s>0 ]", false},
                                                 {"P<0.5 [ F s=3 ]", true},
                                                 {"P>0 [ F s=5 ]", false},
                                                 {"P<=0 [ F s=5 ]", true}};
  for (const auto& [property, truth] : truths) {
    EXPECT_EQ(answered(coin, property).verdict, truth) << property;
    if (property[0] == 'f') {
      EXPECT_EQ(number(coin, property), truth ? 1 : 0) << property;
    }
  }
  const auto fault = [](const char* property) {
    return parse_prism_properties({coin, ""}, {property, ""}).at(0).fault;
  };
  EXPECT_EQ(fault("filter(forall, P=? [ F s=3 ])"), "the filter forall of numbers");
  EXPECT_EQ(fault("filter(print, P=? [ F s=3 ])"), "a filter that asks for print");
  EXPECT_EQ(fault("filter(min, P=? [ F s=3 ], P=? [ F s=1 ])"), "the states of a filter are a condition");
  EXPECT_EQ(fault("P=? [ F P=? [ F s=3 ] ]"), "expected a condition");
  EXPECT_THROW(answered(coin, "filter(state, P=? [ F s=3 ], s>2)"), std::invalid_argument);
  for (const char* property : {"filter(min, P=? [ F s=3 ], s>4)", "filter(first, P=? [ F s=3 ], s>4)"})
    EXPECT_THROW(answered(coin, property), std::invalid_argument) << property;
}

// The chance of state 2 is a half from states 0 and 1, which lead to each other.
constexpr const char* pair_of_rooms = R"(dtmc
module m
  s : [0..3];
  [] s=0 -> 0.5:(s'=1) + 0.25:(s'=2) + 0.25:(s'=3);
  [] s=1 -> 0.5:(s'=0) + 0.25:(s'=2) + 0.25:(s'=3);
  [] s>1 -> true;
endmodule
)";

TEST(PropertyAnswer, IsNoneWhereTheBoundsLieOnBothSides) {
  const PropertyAnswer at_the_bound = answered(pair_of_rooms, "P>=0.5 [ F s=2 ]");
  ASSERT_LT(at_the_bound.answer.value.lower, 0.5);
  ASSERT_GE(at_the_bound.answer.value.upper, 0.5);
  EXPECT_EQ(at_the_bound.verdict, std::nullopt);
  EXPECT_EQ(answered(pair_of_rooms, "P>=0.499999 [ F s=2 ]").verdict, true);
}

TEST(PropertyAnswer, OfNestedOperatorsAsksForNarrowerBoundsWhereItMust) {
  const auto counted = [](const char* property) {
    const std::vector<PrismProperty> all = parse_prism_properties({pair_of_rooms, ""}, {property, ""});
    return answer(all.at(0), {.tolerance = 1e-3, .explain = false});
  };
  EXPECT_EQ(counted("filter(count, P>=0.4999999 [ F s=2 ])").answer.value.lower, 3);
  EXPECT_EQ(counted("filter(count, P>=0.5000001 [ F s=2 ])").answer.value.lower, 1);
  const PropertyAnswer at_the_bound = counted("filter(count, P>=0.5 [ F s=2 ])");
  EXPECT_EQ(at_the_bound.answer.status, CaseAnswer::Status::Exhausted);
  EXPECT_EQ(at_the_bound.answer.reason, "the bounds do not tell whether P>=0.5 [ F s=2 ] holds in state 0");
}

TEST(PropertyAnswer, TheFirstStateCountsLikeOthers) {
  constexpr const char* back_and_forth = R"(dtmc
module m
  s : [0..1];
  [] true -> (s'=1-s);
endmodule
)";
  EXPECT_NEAR(number(back_and_forth, "S=? [ s=0 ]"), 0.5, 1e-9);
  const PropertyAnswer first = answered(back_and_forth, "s=0");
  EXPECT_EQ(first.verdict, true);
  EXPECT_EQ(first.answer.value.lower, 1);
  EXPECT_EQ(first.answer.value.upper, 1);
}

// Either is sure to be lit, or the lamp at a price; the lamp and the door exclude each other.
constexpr const char* lamp = R"(mdp
module m
  s : [0..3];
  [door] s=0 -> (s'=1);
  [lamp] s=0 -> 0.8:(s'=2) + 0.2:(s'=3);
  [] s>0 -> true;
endmodule
rewards "price" [lamp] true : 5; endrewards
rewards "step" true : 1; endrewards
)";

TEST(PropertyAnswer, OfSeveralObjectives) {
  const PropertyAnswer curve = answered(lamp, "multi(Pmax=? [ F s=2 ], R{\"price\"}min=? [ C ])");
  ASSERT_EQ(curve.curve.size(), 2U);
  EXPECT_EQ(curve.curve[0].values, (std::vector<double>{0, 0}));
  EXPECT_NEAR(curve.curve[1].values[0], 0.8, 1e-9);
  EXPECT_NEAR(curve.curve[1].values[1], 5, 1e-9);
  ASSERT_FALSE(curve.curve[1].decisions.empty());
  EXPECT_EQ(number(lamp, "multi(Pmax=? [ F s=2 ], Pmax=? [ F s=1 ])"), 0) << "a curve is no value";
  EXPECT_EQ(curve.curve[1].decisions[0].action, "lamp");
  EXPECT_EQ(agrees("[(0.8,5),(0,0)]", curve.curve), true);
  EXPECT_EQ(agrees("[(0.8,5),(0,1)]", curve.curve), false);
  EXPECT_EQ(agrees("[(0.8,5)]", curve.curve), false);
  const std::pair<const char*, double> numbers[] = {{"multi(Pmax=? [ F s=2 ], P>=0.25 [ F s=1 ])", 0.6},
                                                    {"multi(Pmax=? [ F s=2 ], R{\"price\"}<=4 [ C ])", 0.64},
                                                    {"multi(R{\"price\"}min=? [ C ], P>=0.4 [ F s=2 ])", 2.5},
                                                    {"multi(P>=0.1 [ G s!=3 ], Pmax=? [ F s=3 ])", 0.2},
                                                    {"multi(Pmin=? [ F s=1 ])", 0}};
  for (const auto& [property, value] : numbers) EXPECT_NEAR(number(lamp, property), value, 1e-6) << property;
  const std::pair<const char*, const char*> faults[] = {
      {"multi(P>0.8 [ F s=2 ])", "a strict bound of an objective"},
      {"multi(Pmax=? [ F s=1 ], P<0.2 [ F s=2 ])", "a strict bound of an objective"},
      {"multi(Pmax=? [ F s=1 ], P>=0.2 [ F P>0.5 [ F s=2 ] ])", "an operator inside of an objective"},
      {"multi(Pmax=? [ F s=1 ], R{\"step\"}min=? [ F s=2 ])", "objectives are probabilities and total rewards (C)"},
      {"multi(Pmax=? [ F s=1 ], Pmax=? [ F s=2 ], Pmax=? [ F s=3 ])", "more than two objectives"}};
  for (const auto& [property, fault] : faults)
    EXPECT_EQ(parse_prism_properties({lamp, ""}, {property, ""}).at(0).fault, fault) << property;
  EXPECT_EQ(number(lamp, "Pmax=? [ F{\"price\"}<5 s=2 ]"), 0);
  EXPECT_NEAR(number(lamp, "Pmax=? [ s<2 U{\"price\"}<=5 s=2 ]"), 0.8, 1e-6);
  EXPECT_EQ(answered(lamp, "multi(P>=0.4 [ F s=2 ], P>=0.5 [ F s=1 ])").verdict, true);
  EXPECT_EQ(answered(lamp, "multi(P>=0.41 [ F s=2 ], P>=0.5 [ F s=1 ])").verdict, false);
  EXPECT_EQ(answered(lamp, "multi(Pmax=? [ F s=1 ], P>=0.9 [ F s=2 ])").answer.status, CaseAnswer::Status::Infeasible);
  EXPECT_THROW(answered(lamp, "multi(Pmax=? [ F s=1 ], R{\"step\"}max=? [ C ])"), std::invalid_argument);
  EXPECT_THROW(answered(lamp, "multi(Pmax=? [ F s=1 ], Pmax=? [ G F s=2 ])"), std::invalid_argument);
  EXPECT_TRUE(answered(lamp, "multi(Pmax=? [ F s=1 ], R{\"step\"}min=? [ C ])").curve.empty());
}

}  // namespace
}  // namespace waymark::plan
