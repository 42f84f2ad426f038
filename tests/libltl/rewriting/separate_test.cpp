#include "libltl/rewriting/separate.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

Formula separated(Formula f) { return separate(nnf(f)); }

TEST(Separate, KeepsTheMeaningOnAllSmallPairs) {
  Arena arena;
  const auto lassos = testing::all_lassos({.length = 3, .atoms = 2});
  std::size_t changed = 0;
  testing::for_each_formula(arena, {.size = testing::sanitized ? 4 : 5, .atoms = 2}, [&](Formula f) {
    const Formula g = separated(f);
    if (g == f) return;
    ++changed;
    for (const Lasso& word : lassos)
      ASSERT_EQ(holds(word, f), holds(word, g)) << show(f, word) << "\nbecame " << print(g);
  });
  EXPECT_GT(changed, testing::sanitized ? 50U : 1'000U);
}

TEST(Separate, KeepsTheMeaningOnRandomPairs) {
  constexpr std::uint64_t seed = 17;
  Random random(seed);
  for (int i = 0; i < 2'000; ++i) {
    Arena arena(testing::letters_vocabulary(3));
    const Formula f = random_formula(random, arena, {.size = 8 + random.below(16), .atoms = 3});
    const Formula g = separated(f);
    for (int j = 0; j < 20; ++j) {
      const Lasso word = random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = 3});
      ASSERT_EQ(holds(word, f), holds(word, g))
          << show(f, word) << "\nbecame " << print(g) << "\nseed " << seed << ", formula " << i;
    }
  }
}

// Formulas like those that the rules with a negated operand are about, and such as only look like them.
TEST(Separate, KeepsTheMeaningWhereAnOperandIsNegatedBeside) {
  const char* const beside[] = {"!a", "b", "F b", "G b", "F !b", "G !b", "X b", "a U b", "F G b", "G F b"};
  const auto lassos = testing::all_lassos({.length = 3, .atoms = 2});
  std::size_t changed = 0;
  for (const std::string one : beside)
    for (const std::string other : beside)
      for (const std::string third : beside)
        for (const std::string& text : {"G a | F(" + one + " & " + other + " & " + third + ")",
                                        "F !a & G(" + one + " | " + other + " | " + third + ")"}) {
          Arena arena(testing::letters_vocabulary(2));
          const Formula f = parse(text, arena), g = separated(f);
          changed += g == nnf(f) ? 0 : 1;
          for (const Lasso& word : lassos) ASSERT_EQ(holds(word, f), holds(word, g)) << text << " became " << print(g);
        }
  EXPECT_GT(changed, 100U);
}

// v ⊨ φ implies uv ⊨ φ, and the other way round: the suffixes of a lasso are lassos.
TEST(Separate, PurityIsAClaimAboutSuffixes) {
  Arena arena;
  const auto lassos = testing::all_lassos({.length = 3, .atoms = 2});
  const auto suffix = [](const Lasso& word) {
    std::vector<Letter> prefix, cycle;
    for (std::size_t i = 1; i < word.loop_start(); ++i) prefix.push_back(word[i]);
    const std::size_t start = word.loop_start() == 0 ? 1 : word.loop_start();
    for (std::size_t i = start; i < word.size(); ++i) cycle.push_back(word[i]);
    if (word.loop_start() == 0) cycle.push_back(word[0]);
    return Lasso(prefix, cycle);
  };
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const Purity pure = purity(nnf(f));
    for (const Lasso& word : lassos) {
      const bool now = holds(word, f), later = holds(suffix(word), f);
      if (pure.eventual) {
        ASSERT_TRUE(!later || now) << show(f, word);
      }
      if (pure.universal) {
        ASSERT_TRUE(!now || later) << show(f, word);
      }
    }
  });
}

TEST(Separate, PullsOutWhatMayBeLookedAtLate) {
  const struct {
    const char *formula, *separated;
  } table[] = {
      {"X G F a", "G F a"},
      {"a U (b | F c)", "a U b | F c"},
      {"a R (b & G c)", "a R b & G c"},
      {"F(a & G F b)", "F a & G F b"},
      {"G F(a & X F b)", "G F a & G F b"},
      {"F G(a | X G b)", "F G a | F G b"},
      {"G((a | G F b) & c)", "(G a | G F b) & G c"},
      {"a U ((b & G F c) | d)", "(a U b & G F c) | a U d"},
      {"G a U b", "(G a | b) & F b"},
      {"F a R b", "(F a & b) | G b"},
      {"b W F a", "F a | G b"},
      {"a U (a & F b)", "a & F b"},
      {"(a & G F b) U c", "c | (G F b & a U c)"},
      {"G a | F(!a & F b)", "a W (!a & F b)"},
      {"F a & G(!a | G b)", "!a U (a & G b)"},
      {"F G X a", "F G a"},
      {"a U (b | G a)", "a W b"},
      {"a R (b & F a)", "a M b"},
      {"a U b | G a", "a W b"},
      {"a R b & F a", "a M b"},
      {"G a | a U b", "a W b"},
      {"F a & a R b", "a M b"},
      {"F(!a & F b) | G a", "a W (!a & F b)"},
      {"G(!a | G b) & F a", "!a U (a & G b)"},
  };
  for (const auto& row : table) {
    Arena arena;
    const Formula expected = parse(row.separated, arena);
    EXPECT_EQ(print(separated(parse(row.formula, arena))), print(expected)) << row.formula;
  }
}

}  // namespace
}  // namespace waymark::ltl
