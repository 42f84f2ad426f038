#include "libltl/rewriting/delta2.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/hierarchy.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

constexpr std::size_t plenty = 10'000;

TEST(Hierarchy, IsReadOffTheSyntax) {
  const struct {
    const char* formula;
    std::uint32_t sigma, pi, delta;
  } table[] = {
      {"a & !b", 0, 0, 0},        {"X a", 1, 1, 1},
      {"F a", 1, 2, 1},           {"G a", 2, 1, 1},
      {"!F a", 2, 1, 1},          {"a M b", 1, 2, 1},
      {"a W b", 2, 1, 1},         {"F a | G b", 2, 2, 1},
      {"F a <-> b", 2, 2, 1},     {"X(F a & G b)", 2, 2, 2},
      {"G F a", 3, 2, 2},         {"F G a", 2, 3, 2},
      {"G(a -> F b)", 3, 2, 2},   {"G F a -> G F b", 3, 3, 2},
      {"a U (b & G c)", 2, 3, 2}, {"F(a & G(b | F c))", 3, 4, 3},
      {"G F(a & G b)", 4, 3, 3},  {"X(G F a | F G b)", 3, 3, 3},
      {"G F a U G F b", 3, 4, 3},
  };
  for (const auto& row : table) {
    Arena arena;
    EXPECT_EQ(level(parse(row.formula, arena)), (Level{row.sigma, row.pi, row.delta})) << row.formula;
  }
}

TEST(Hierarchy, NegationExchangesTheClassesAndKeepsTheCombinations) {
  Arena arena;
  testing::for_each_formula(arena, {.size = 5, .atoms = 2}, [&](Formula f) {
    const Level at = level(f);
    ASSERT_EQ(level(nnf(negate(f))), (Level{at.pi, at.sigma, at.delta})) << show(f);
  });
}

TEST(Delta2, IsWhatItSaysAndMeansTheSameOnAllSmallPairs) {
  Arena arena;
  const auto lassos = testing::all_lassos({.length = 4, .atoms = 1});
  std::size_t changed = 0;
  testing::for_each_formula(arena, {.size = 7, .atoms = 1}, [&](Formula f) {
    if (is_delta2(f)) return;
    ++changed;
    const std::optional<Formula> g = delta2(f, plenty);
    ASSERT_TRUE(g) << show(f);
    ASSERT_TRUE(is_delta2(*g)) << show(f) << "\nbecame " << print(*g);
    for (const Lasso& word : lassos)
      ASSERT_EQ(holds(word, f), holds(word, *g)) << show(f, word) << "\nbecame " << print(*g);
  });
  EXPECT_GT(changed, 10U);
}

TEST(Delta2, IsWhatItSaysAndMeansTheSameOnRandomPairs) {
  constexpr std::uint64_t seed = 82;
  Random random(seed);
  std::size_t changed = 0, too_large = 0;
  for (int i = 0; i < 2'000; ++i) {
    Arena arena(testing::letters_vocabulary(3));
    const Formula f = random_formula(random, arena, {.size = 8 + random.below(12), .atoms = 3});
    const std::optional<Formula> g = delta2(f, 500);
    if (!g) {
      ++too_large;
      continue;
    }
    if (!is_delta2(f)) ++changed;
    ASSERT_TRUE(is_delta2(*g)) << show(f) << "\nbecame " << print(*g) << "\nseed " << seed << ", formula " << i;
    for (int j = 0; j < 20; ++j) {
      const Lasso word = random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = 3});
      ASSERT_EQ(holds(word, f), holds(word, *g))
          << show(f, word) << "\nbecame " << print(*g) << "\nseed " << seed << ", formula " << i;
    }
  }
  EXPECT_GT(changed, 200U);
  EXPECT_LT(too_large, 20U);
}

TEST(Delta2, RewritesNoMoreThanItMust) {
  const struct {
    const char *formula, *normal;
  } table[] = {
      {"G(a -> F b)", "G(a -> F b)"},
      {"G F a & F(b U G c)", "G F a & F(b U (G c))"},
      {"F(a & G(b | F c))", "F(a & ((b | F c) U (G b))) | (G F c & F a)"},
      {"G F(a & G b)", "G F a & F G b"},
      {"F G(a | F b)", "F G a | G F b"},
      {"(a U b) W c", "(a U b) W c"},
      {"a W (b U G c)", "G a | (a U (b U (G c)))"},
      {"(G F a) U (F G b)", "F G b"},
      {"G(a | X(b U G c))", "G(a | X(b W (G c))) & (G a | F G c)"},
      {"(F a) R (G b | F c)", "(F a) R (G b | F c)"},
  };
  for (const auto& row : table) {
    Arena arena;
    const std::optional<Formula> made = delta2(parse(row.formula, arena), plenty);
    ASSERT_TRUE(made) << row.formula;
    EXPECT_EQ(*made, parse(row.normal, arena)) << row.formula << "\nbecame " << print(*made);
  }
}

TEST(Delta2, GivesUpAtItsLimit) {
  Arena arena;
  const Formula f = parse("F(a & G(b | F(c & G(d | F(e & G(f | F g))))))", arena);
  EXPECT_FALSE(delta2(f, 20));
  EXPECT_TRUE(delta2(f, plenty));
}

}  // namespace
}  // namespace waymark::ltl
