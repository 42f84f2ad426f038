#include "libltl/meaning/progress.hpp"

#include <gtest/gtest.h>

#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

constexpr Proposition a{0}, b{1};
const Letter none{}, only_a{a}, only_b{b};

struct Row {
  const char* formula;
  Letter letter;
  const char *finite, *infinite;
};

TEST(Progress, ReadsOneLetter) {
  const Row table[] = {
      {"a", only_a, "true", "true"},
      {"a", none, "false", "false"},
      {"!a", none, "true", "true"},
      {"X b", none, "b & F true", "b"},
      {"N b", none, "b | G false", "b"},
      {"X X b", none, "X b & F true", "X b"},
      {"a U b", only_a, "a U b", "a U b"},
      {"a U b", only_b, "true", "true"},
      {"a U b", none, "false", "false"},
      {"a R b", only_b, "a R b", "a R b"},
      {"F(a & X b)", only_a, "(b & F true) | F(a & X b)", "b | F(a & X b)"},
      {"G(a -> X b)", only_a, "b & F true & G(a -> X b)", "b & G(a -> X b)"},
      {"a <-> X b", none, "!(b & F true)", "!b"},
      {"G false", none, "false", "false"},
      {"F true", none, "true", "true"},
  };
  for (const Row& row : table) {
    Arena arena(testing::letters_vocabulary(2));
    const Formula f = parse(row.formula, arena);
    EXPECT_EQ(progress(f, row.letter), parse(row.finite, arena)) << show(f);
    EXPECT_EQ(progress(f, row.letter, Semantics::Infinite), parse(row.infinite, arena)) << show(f);
  }
}

TEST(Conventions, TheEmptyRestSatisfiesAlwaysReleaseAndWeakNextOnly) {
  const struct {
    const char* formula;
    bool accepts;
  } table[] = {{"true", true},    {"false", false},  {"a", false},      {"!a", true},     {"X true", false},
               {"N false", true}, {"F true", false}, {"G false", true}, {"a U b", false}, {"a R b", true},
               {"a W b", true},   {"a M b", false},  {"a <-> b", true}, {"a ^ b", false}, {"!F a", true}};
  for (const auto& row : table) {
    Arena arena;
    EXPECT_EQ(accepts_empty(parse(row.formula, arena)), row.accepts) << row.formula;
  }
}

bool accepts_by_progression(Formula f, const Trace& word) {
  for (const Letter& letter : word) f = progress(f, letter);
  return accepts_empty(f);
}

TEST(Laws, ProgressionAgreesWithTheDefinition) {
  Arena arena(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    for (const Trace& word : words) ASSERT_EQ(accepts_by_progression(f, word), holds(word, f)) << show(f, word);
  });
}

TEST(Laws, ProgressionAgreesWithTheDefinitionOnRandomPairs) {
  Arena arena(testing::letters_vocabulary(3));
  Random random(2);
  for (int i = 0; i < 3'000; ++i) {
    const Formula f = random_formula(random, arena, {.size = 15, .atoms = 3});
    const Trace word = random_trace(random, {.length = 1 + random.below(8), .atoms = 3});
    ASSERT_EQ(accepts_by_progression(f, word), holds(word, f)) << show(f, word) << "   seed 2, pair " << i;
  }
}

// a·w ⊨ φ iff w ⊨ prog(φ, a) on infinite words: reading the first letter of a lasso moves it into the rest.
Lasso rest_of(const Lasso& word) {
  std::vector<Letter> prefix, cycle;
  const bool only_cycle = word.loop_start() == 0;
  for (std::size_t i = 1; i < word.size(); ++i) (i < word.loop_start() ? prefix : cycle).push_back(word[i]);
  if (only_cycle) cycle.push_back(word[0]);
  return Lasso(prefix, cycle);
}

TEST(Laws, ProgressionOnInfiniteWordsReadsTheFirstLetter) {
  Arena arena(testing::letters_vocabulary(2));
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    for (const Lasso& word : words)
      ASSERT_EQ(holds(rest_of(word), progress(f, word[0], Semantics::Infinite)), holds(word, f)) << show(f, word);
  });
}

TEST(Progress, DeepFormulasDoNotOverflow) {
  Arena arena(testing::letters_vocabulary(1));
  Formula f = arena.atom("a");
  for (std::size_t i = 1; i < most_levels; ++i) f = until(f, arena.atom("a"));
  EXPECT_EQ(progress(f, only_a), arena.constant(true));
  EXPECT_FALSE(accepts_empty(f));
}

}  // namespace
}  // namespace waymark::ltl
