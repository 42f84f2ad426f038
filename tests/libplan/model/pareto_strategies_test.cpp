// Curves whose vertices and strategies are known: points that another is better than, values of unlike magnitude,
// strategies that cross an end component, rewards without end.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "libplan/solve/pareto.hpp"
#include "libplan/solve/pareto_product.hpp"

namespace waymark::plan {
namespace {

struct Offer {  // a choice of the first state
  const char* action;
  double cost, chance;  // of `a`
};

// Takes one of the offers, then rests.
Mdp market(const std::vector<Offer>& offers) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  for (const Offer& offer : offers) {
    builder.add_choice(offer.action, offer.cost);
    if (offer.chance > 0) builder.add_outcome(1, a, offer.chance);
    if (offer.chance < 1) builder.add_outcome(1, none, 1 - offer.chance);
  }
  builder.add_state();
  builder.add_choice("rest", 0);
  builder.add_outcome(1, none);
  return std::move(builder).build(0, none);
}

std::vector<std::vector<double>> values_of(const Pareto& found) {
  std::vector<std::vector<double>> out;
  for (const ParetoPoint& point : found.points) out.push_back(point.values);
  return out;
}

Pareto likely_and_cheap(const Mdp& model) {
  return pareto(model, {{"F a", nullptr, true}, {"", &model, false}}).value();
}

TEST(ParetoStrategies, PointsThatAnotherIsBetterThanAreLeftOut) {
  const Pareto found = likely_and_cheap(market({{"dear", 2, 1}, {"cheap", 1, 1}, {"nothing", 0, 0}}));
  EXPECT_EQ(values_of(found), (std::vector<std::vector<double>>{{0, 0}, {1, 1}}));
  EXPECT_EQ(found.points.at(1).decisions.at(0).action, "cheap");
  EXPECT_EQ(found.solutions, 4U) << "the best of each objective, then `cheap` between them, then nothing between two";
}

TEST(ParetoStrategies, PrecisionIsThatOfEachObjective) {
  const Pareto found = likely_and_cheap(market({{"sure", 1e7, 1}, {"likely", 1e6, 0.5}, {"nothing", 0, 0}}));
  EXPECT_EQ(values_of(found), (std::vector<std::vector<double>>{{0, 0}, {0.5, 1e6}, {1, 1e7}}));
}

// Three rooms that lead to one another at no cost; the last one alone leads out.
TEST(ParetoStrategies, CrossTheirEndComponentsByChoicesOfTheirStates) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const LetterId none = builder.letter({}), a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("to the second", 0);
  builder.add_outcome(1, none);
  builder.add_state();
  builder.add_choice("to the third", 0);
  builder.add_outcome(2, none);
  builder.add_state();
  builder.add_choice("to the first", 0);
  builder.add_outcome(0, none);
  builder.add_choice("out", 1);
  builder.add_outcome(3, a);
  builder.add_state();
  builder.add_choice("rest", 0);
  builder.add_outcome(3, none);
  const Pareto found = likely_and_cheap(std::move(builder).build(0, none));
  ASSERT_EQ(values_of(found), (std::vector<std::vector<double>>{{0, 0}, {1, 1}}));
  std::string way;
  for (const ParetoDecision& d : found.points[1].decisions) way += std::to_string(d.state) + " " + d.action + "; ";
  EXPECT_EQ(way, "0 to the second; 1 to the third; 2 out; 3 rest; ");
}

TEST(ParetoStrategies, RewardsWithoutEndAreRefused) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const LetterId none = builder.letter({});
  builder.add_state();
  builder.add_choice("out", 1);
  builder.add_outcome(1, none);
  builder.add_choice("again", 1);
  builder.add_outcome(0, none);
  builder.add_state();
  builder.add_choice("rest", 0);
  builder.add_outcome(1, none);
  const Mdp model = std::move(builder).build(0, none);
  EXPECT_THROW(pareto(model, {{"", &model, true}}), std::invalid_argument);
  const Mdp ends = market({{"little", 1, 0}, {"much", 2, 0}});
  EXPECT_EQ(values_of(pareto(ends, {{"", &ends, true}}).value()), (std::vector<std::vector<double>>{{2}}));
}

// Two states are enough for the product, whose first letter decides; the automaton has more.
TEST(ParetoStrategies, AutomataKeepToTheLimitOfStates) {
  MdpBuilder builder(ltl::Vocabulary({"a", "b"}));
  const LetterId a = builder.letter({ltl::Proposition{0}});
  builder.add_state();
  builder.add_choice("rest", 0);
  builder.add_outcome(0, a);
  const Mdp model = std::move(builder).build(0, a);
  const std::vector<Objective> objectives{{"a | X X X X X b", nullptr, true}};
  EXPECT_TRUE(pareto_product(model, objectives, {.states = 100}));
  EXPECT_FALSE(pareto_product(model, objectives, {.states = 4}));
}

}  // namespace
}  // namespace waymark::plan
