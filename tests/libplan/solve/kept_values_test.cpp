// Values by state, kept where they are asked for: the best of what the choices of each state come to.
#include <gtest/gtest.h>

#include <algorithm>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libplan/solve/decide.hpp"
#include "tests/libplan/solve/random_models.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::plan {
namespace {

TEST(KeptValues, AreGreatestProbabilitiesOfEveryState) {
  ltl::Random random(46);
  int some = 0;
  for (int i = 0; i < waymark::testing::scaled(2'000); ++i) {
    ltl::Arena arena(testing::vocabulary_ab());
    const ltl::Formula f = ltl::random_formula(random, arena, {.size = 6 + random.below(9), .atoms = 2});
    const Mdp mdp = testing::random_model(random, {.states = 4});
    const automata::Dfa dfa = automata::ltlf_to_dfa(f);
    const TaskTable task(dfa, mdp.letters());
    const auto product = ProductMdp<Mdp>::explore(mdp, task);
    const auto plain = greatest_probability(*product), kept = greatest_probability(*product, {.keep_values = true});
    ASSERT_TRUE(plain && kept);
    if (kept->value.lower == 0 || kept->value.upper == 1) continue;  // by the graph
    ++some;
    EXPECT_TRUE(plain->values.empty());
    ASSERT_EQ(kept->values.size(), product->states());
    product->for_each_state([&](const auto& s) {
      double best = 0;
      for (std::uint32_t k = 0; k < product->choices(s); ++k) {
        double sum = 0;
        product->for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
          if (t != ProductMdp<Mdp>::trap) sum += p * kept->values[t];
        });
        best = std::max(best, sum);
      }
      EXPECT_NEAR(kept->values[s.index], product->is_goal(s) ? 1 : best, 1e-5) << i << ", state " << s.index;
    });
    for (const std::uint32_t start : product->starts()) EXPECT_LE(kept->values[start], kept->value.upper + 1e-6) << i;
  }
  EXPECT_GT(some, waymark::testing::scaled(10));
}

}  // namespace
}  // namespace waymark::plan
