// Model checking on small random models: against the least probability, and every counterexample against the
// definition.
#include "libplan/solve/model_check.hpp"

#include <gtest/gtest.h>

#include <map>

#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

std::string random_text(ltl::Random& random) {
  ltl::Arena arena(testing::vocabulary_ab());
  return ltl::print(ltl::random_formula(random, arena, {.size = 3 + random.below(8), .atoms = 2}));
}

double least_probability(const PlanningCase& model, const std::string& formula) {
  return answer(model, {"", formula, CaseTask::Logic::Ltl, CaseTask::Query::MinProbability}).value.middle();
}

TEST(ModelCheck, HoldsWhereTheLeastProbabilityIsOne) {
  ltl::Random random(19);
  std::size_t hold = 0, paths = 0;
  for (int i = 0; i < waymark::testing::scaled(300); ++i) {
    const auto choices = static_cast<std::uint32_t>(1 + random.below(2));
    const PlanningCase model{"", testing::random_model(random, {.states = 4, .most_choices = choices}), {}};
    const Mdp& mdp = std::get<Mdp>(model.model);
    if (mdp.is_deterministic()) continue;
    const std::string formula = random_text(random);
    const auto found = check_model(model, formula, {.paths = 2'000, .tolerance = 1e-9});
    const double least = least_probability(model, formula);
    ASSERT_EQ(found.value().holds, least > 1 - 1e-9) << formula << '\n' << testing::show(mdp);
    hold += found->holds ? 1 : 0;
    if (found->holds) continue;
    ASSERT_NEAR(found->probability.middle(), least, 1e-5) << formula << '\n' << testing::show(mdp);
    // Paths are disjoint, so their probabilities are at most that of the violation, and nearly all of it.
    ASSERT_LE(found->probability_of_paths, 1 - least + 1e-6) << formula << '\n' << testing::show(mdp);
    ASSERT_GE(found->probability_of_paths, found->paths.size() < 2'000 ? 1 - least - 1e-4 : 0) << formula << '\n'
                                                                                               << testing::show(mdp);
    double last = 1;
    for (const LikelyPath& path : found->paths) {
      ASSERT_LE(path.probability, last);
      ASSERT_EQ(path.places.size(), path.actions.size() + 1);
      last = path.probability;
    }
    paths += found->paths.size();
  }
  EXPECT_GT(hold, 10U);
  EXPECT_GT(paths, 100U);
}

// The automaton of a formula in the place of the formula, of every kind that there is.
TEST(ModelCheck, AnAutomatonIsASpecification) {
  ltl::Random random(34);
  std::size_t hold = 0, lassos = 0;
  for (int i = 0; i < waymark::testing::scaled(150); ++i) {
    const PlanningCase model{
        "", testing::random_model(random, {.states = 4, .most_choices = 2, .deterministic = i % 2 == 0}), {}};
    const std::string formula = random_text(random);
    ltl::Arena arena(testing::vocabulary_ab());
    const GivenAutomaton given = automata::ltl_to_tgba(ltl::parse(formula, arena));
    const auto expected = check_model(model, formula).value(), found = check_model(model, given).value();
    ASSERT_EQ(found.holds, expected.holds) << formula << '\n' << testing::show(std::get<Mdp>(model.model));
    ASSERT_EQ(found.lasso.has_value(), expected.lasso.has_value());
    ASSERT_NEAR(found.probability.middle(), expected.probability.middle(), 1e-5) << formula;
    hold += found.holds ? 1 : 0;
    lassos += found.lasso ? 1 : 0;
  }
  EXPECT_GT(hold, 10U);
  EXPECT_GT(lassos, 10U);
}

// A walk of names has one word here: choices of a state have different names.
TEST(ModelCheck, ALassoViolatesTheFormulaAndIsThereWhereOneDoes) {
  ltl::Random random(20);
  std::size_t lassos = 0;
  for (int i = 0; i < waymark::testing::scaled(300); ++i) {
    const PlanningCase model{
        "", testing::random_model(random, {.states = 4, .most_choices = 2, .deterministic = true}), {}};
    const Mdp& mdp = std::get<Mdp>(model.model);
    const std::string formula = random_text(random);
    const auto found = check_model(model, formula);
    ASSERT_EQ(found.value().holds, least_probability(model, formula) > 0.5) << formula << '\n' << testing::show(mdp);
    if (found->holds) continue;
    ++lassos;
    std::uint32_t at = mdp.initial();
    std::vector<ltl::Letter> before{mdp.letters()[mdp.initial_letter()]}, again;
    const auto walk = [&](const NamedRoute& route, std::vector<ltl::Letter>& letters) {
      for (std::size_t step = 0; step < route.actions.size(); ++step)
        for (std::uint32_t k = 0; k < mdp.choices(at); ++k) {
          if (mdp.action(at, k) != route.actions[step]) continue;
          letters.push_back(mdp.letters()[mdp.outcome(at, k, 0).letter]);
          at = mdp.outcome(at, k, 0).target;
          ASSERT_EQ(mdp.name(at), route.places[step + 1]);
          break;
        }
    };
    walk(found->lasso->prefix, before);
    walk(found->lasso->cycle, again);
    ltl::Arena arena(mdp.letters().vocabulary());
    ASSERT_FALSE(ltl::holds(ltl::Lasso(before, again), ltl::parse(formula, arena))) << formula << testing::show(mdp);
  }
  EXPECT_GT(lassos, 20U);
}

TEST(ModelCheck, ReasonsNameWhatCannotBeHad) {
  MdpBuilder builder(testing::vocabulary_ab());
  const LetterId a = builder.letter({ltl::Proposition{0}}), none = builder.letter({});
  builder.add_state("here");
  builder.add_choice("stay");
  builder.add_outcome(0, a);
  const PlanningCase one{"", std::move(builder).build(0, none), {}};
  const auto reason = [&](const char* formula, CaseTask::Query query) {
    return answer(one, {"", formula, CaseTask::Logic::Ltl, query}).reason;
  };
  EXPECT_EQ(reason("G F a & F G !a & F a", CaseTask::Query::LeastLasso), "no walk without end satisfies F G !a");
  EXPECT_EQ(reason("G !b", CaseTask::Query::MinCost),
            "no strategy is sure to come to a finite prefix that decides G !b");
  EXPECT_EQ(reason("F a & G !b", CaseTask::Query::MinCost),
            "no strategy is sure to come to a finite prefix that decides G !b");
  EXPECT_EQ(reason("F b", CaseTask::Query::MinCost),
            "no strategy is sure to satisfy F b; never seen from the start: b");
}

}  // namespace
}  // namespace waymark::plan
