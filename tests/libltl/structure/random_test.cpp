#include "libltl/structure/random.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "libltl/text/print.hpp"
#include "libltl/text/view.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

TEST(Conventions, TheSameSeedGivesTheSameFormulasAndWords) {
  Arena arena(testing::letters_vocabulary(3));
  Random random(1);
  // Fixed text, not two runs compared: std::mt19937_64 is the same on every machine, and so must these be.
  EXPECT_EQ(print(random_formula(random, arena, {.size = 10, .atoms = 3})), "G !N G !(a U b)");
  EXPECT_EQ(show(random_trace(random, {.length = 3, .atoms = 3}), arena.vocabulary()), "{a, b}; {a, b, c}; {a, b, c}");
  EXPECT_EQ(show(random_lasso(random, {.prefix = 1, .cycle = 2, .atoms = 3}), arena.vocabulary()),
            "{}; ({a, c}; {a})ʷ");
}

TEST(Random, DrawsEveryNumberEquallyOften) {
  Random random(7);
  std::vector<int> count(5);
  for (int i = 0; i < 50'000; ++i) ++count[random.below(5)];
  for (int n : count) EXPECT_NEAR(n, 10'000, 400);  // four and a half standard deviations
  for (int i = 0; i < 1'000; ++i) {
    const double x = random.unit();
    EXPECT_TRUE(x >= 0 && x < 1) << x;
  }
}

TEST(Random, FormulasReachEveryOperatorAndKeepToTheirOptions) {
  Arena arena(testing::letters_vocabulary(4));
  Random random(8);
  std::set<Op> seen;
  for (int i = 0; i < 500; ++i)
    for (Formula g : subformulas(random_formula(random, arena, {.size = 12, .atoms = 2}))) seen.insert(g.op());
  EXPECT_EQ(seen.size(), 11U);
  for (int i = 0; i < 500; ++i) {
    const Formula f = random_formula(random, arena, {.size = 9, .atoms = 2, .constants = false, .weak_next = false});
    for (Formula g : subformulas(f)) EXPECT_NE(g.op(), Op::WeakNext) << testing::show(f);
    for (Proposition p : propositions(f)) EXPECT_LT(p.index, 2U) << testing::show(f);
  }
}

// A third of the operators speak of the past, each of the six about as often as the others of as many operands.
TEST(Random, FormulasOfThePastReachItsOperatorsEquallyOften) {
  Arena arena(testing::letters_vocabulary(2));
  Random random(10);
  std::map<Symbol, int> count;
  constexpr int drawn = 12'000;
  for (int i = 0; i < drawn; ++i)
    ++count[view(random_formula(random, arena, {.size = 2, .atoms = 2, .constants = false, .past = true})).symbol];
  for (const Symbol unary : {Symbol::Yesterday, Symbol::WeakYesterday, Symbol::Once, Symbol::Historically})
    EXPECT_NEAR(count[unary], drawn / 12.0, 150);
  EXPECT_NEAR(count[Symbol::Next] + count[Symbol::WeakNext], drawn * 4 / 15.0, 250);
  count.clear();
  for (int i = 0; i < drawn; ++i)
    ++count[view(random_formula(random, arena, {.size = 3, .atoms = 2, .constants = false, .past = true})).symbol];
  EXPECT_NEAR(count[Symbol::Since], count[Symbol::Triggered], 250);
  EXPECT_GT(count[Symbol::Since], drawn / 2 / 3 / 2 - 500);
  for (int i = 0; i < 500; ++i) EXPECT_FALSE(has_past(random_formula(random, arena, {.size = 9, .atoms = 2})));
}

TEST(Random, RefusesWhatCannotBeMade) {
  Arena arena(testing::letters_vocabulary(1));
  Random random(9);
  EXPECT_THROW(random_formula(random, arena, {.atoms = 2}), std::invalid_argument);
  EXPECT_THROW(random_formula(random, arena, {.atoms = 0, .constants = false}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::ltl
