#include "libltl/meaning/semantics.hpp"

#include <gtest/gtest.h>

#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

constexpr Proposition a{0}, b{1};
const Letter none{}, only_a{a}, only_b{b}, both{a, b};

struct Row {
  const char* formula;
  std::vector<Letter> letters;
  bool holds;
};

TEST(Holds, OnFiniteWords) {
  const Row table[] = {
      {"a", {only_a}, true},
      {"X true", {none}, false},
      {"N false", {none}, true},
      {"X true", {none, none}, true},
      {"N false", {none, none}, false},
      {"X a", {none, only_a}, true},
      {"a U b", {only_a, only_a, only_b}, true},
      {"a U b", {only_a, only_a}, false},
      {"a U b", {only_a, none, only_b}, false},
      {"a R b", {only_b, only_b}, true},
      {"a R b", {only_b, both, none}, true},
      {"a R b", {only_b, only_a}, false},
      {"a W b", {only_a, only_a}, true},
      {"b M a", {only_a, only_a}, false},
      {"F a", {none, none, only_a}, true},
      {"G a", {only_a, none}, false},
      {"a <-> b", {none}, true},
      {"a ^ b", {both}, false},
      {"F(a & N false)", {only_a, none}, false},  // a at the last position
      {"F<=1 a", {none, none, only_a}, false},
      {"G<=3 a", {only_a, only_a}, true},
      {"F<=3 a", {none, none}, false},
  };
  for (const Row& row : table) {
    Arena arena(testing::letters_vocabulary(2));
    const Formula f = parse(row.formula, arena);
    const Trace word(row.letters);
    EXPECT_EQ(holds(word, f), row.holds) << testing::show(f, word);
  }
}

struct LassoRow {
  const char* formula;
  std::vector<Letter> prefix, cycle;
  bool holds;
};

TEST(Holds, OnLassos) {
  const LassoRow table[] = {
      {"G F a", {}, {none, only_a}, true},
      {"F G a", {}, {none, only_a}, false},
      {"F G a", {none, none}, {only_a}, true},
      {"X X X a", {none}, {only_a, none}, true},  // positions 0 | 1 2 | 1: X X X reads position 3 = 1
      {"a U b", {only_a}, {only_a}, false},
      {"a U b", {only_a}, {only_a, only_b}, true},
      {"b R a", {}, {only_a}, true},
      {"X a <-> N a", {only_a}, {none}, true},
  };
  for (const LassoRow& row : table) {
    Arena arena(testing::letters_vocabulary(2));
    const Formula f = parse(row.formula, arena);
    const Lasso word(row.prefix, row.cycle);
    EXPECT_EQ(holds(word, f), row.holds) << testing::show(f, word);
  }
}

TEST(Conventions, WeakNextIsTheDualOfStrongNext) {
  Arena arena(testing::letters_vocabulary(1));
  testing::for_each_formula(arena, {.size = 3, .atoms = 1}, [](Formula f) {
    testing::for_each_trace({.length = 3, .atoms = 1}, [&](const Trace& word) {
      EXPECT_EQ(holds(word, negate(next(f))), holds(word, weak_next(negate(f)))) << testing::show(f, word);
    });
    testing::for_each_lasso({.length = 3, .atoms = 1}, [&](const Lasso& word) {
      EXPECT_EQ(holds(word, next(f)), holds(word, weak_next(f))) << testing::show(f, word);
    });
  });
}

TEST(Holds, DeepFormulasDoNotOverflow) {
  Arena arena(testing::letters_vocabulary(1));
  Formula f = arena.atom("a");
  for (std::size_t i = 1; i < most_levels; ++i) f = weak_next(f);
  EXPECT_TRUE(holds(Trace({none}), f));
  EXPECT_FALSE(holds(Lasso({}, {none}), f));
}

}  // namespace
}  // namespace waymark::ltl
