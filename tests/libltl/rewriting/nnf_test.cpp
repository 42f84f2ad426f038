#include "libltl/rewriting/nnf.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

struct Row {
  const char *formula, *expanded, *keeping;
};

TEST(Nnf, PushesNegationsToTheAtoms) {
  const Row table[] = {
      {"!(a U b)", "!a R !b", "!a R !b"},
      {"!(a R b)", "!a U !b", "!a U !b"},
      {"!X a", "N !a", "N !a"},
      {"!N a", "X !a", "X !a"},
      {"!F a", "G !a", "G !a"},
      {"!(a & G b)", "!a | F !b", "!a | F !b"},
      {"!(a -> X b)", "a & N !b", "a & N !b"},
      {"a <-> b", "(a & b) | (!a & !b)", "a <-> b"},
      {"a ^ X b", "(a & N !b) | (!a & X b)", "a ^ X b"},
      {"!G(a ^ !F b)", "F((a & G !b) | (!a & F b))", "F(a ^ F b)"},
  };
  for (const Row& row : table) {
    Arena arena;
    const Formula f = parse(row.formula, arena);
    EXPECT_EQ(nnf_keeping_iff(f), parse(row.keeping, arena)) << print(nnf_keeping_iff(f));
    EXPECT_EQ(nnf(f), parse(row.expanded, arena)) << print(nnf(f));
  }
}

bool is_normal(Formula f, bool iff_allowed) {
  for (Formula g : subformulas(f)) {
    if (g.op() == Op::Iff && !iff_allowed) return false;
    if (g.op() == Op::Not && g[0].op() != Op::Atom && !(iff_allowed && g[0].op() == Op::Iff)) return false;
  }
  return true;
}

TEST(Nnf, OppositesAreTheNormalFormsOfNegations) {
  Arena arena(testing::letters_vocabulary(2));
  Opposites opposites;  // remembers the parts of all of them
  testing::for_each_formula(arena, {.size = 4, .atoms = 2},
                            [&](Formula f) { ASSERT_EQ(opposites.of(f), nnf_keeping_iff(negate(f))) << show(f); });
}

TEST(Laws, NormalFormsMeanTheSame) {
  Arena arena(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  const auto lassos = testing::all_lassos({.length = 2, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const Formula expanded = nnf(f), keeping = nnf_keeping_iff(f);
    ASSERT_TRUE(is_normal(expanded, false)) << show(expanded);
    ASSERT_TRUE(is_normal(keeping, true)) << show(keeping);
    for (const Trace& word : words) {
      ASSERT_EQ(holds(word, expanded), holds(word, f)) << show(f, word);
      ASSERT_EQ(holds(word, keeping), holds(word, f)) << show(f, word);
    }
    for (const Lasso& word : lassos) ASSERT_EQ(holds(word, expanded), holds(word, f)) << show(f, word);
  });
}

}  // namespace
}  // namespace waymark::ltl
