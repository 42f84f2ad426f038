// LTL to Büchi against the definition: every small formula on every small lasso, then seeded random larger pairs, and
// φ against ¬φ. A disagreement is printed ready to paste.
#include "libautomata/translation/ltl_to_buchi.hpp"

#include <gtest/gtest.h>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Lasso;
using testing::show;

::testing::AssertionResult agree(Formula f, const Automaton& automaton, const Lasso& word) {
  if (accepts(automaton, word) == ltl::holds(word, f)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << show(f, word) << " holds: " << ltl::holds(word, f);
}

bool marks_are_on_states(const Automaton& automaton) {
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const Branch& b : branches_of(automaton.transitions(), q))
      if (b.marks != branches_of(automaton.transitions(), q).front().marks) return false;
  return automaton.acceptance().is_buchi();
}

bool is_trimmed(const Automaton& automaton) {
  const LiveComponents live = live_components(BranchGraph(automaton.transitions()), automaton.acceptance().condition);
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    if (!live.live[q]) return automaton.states() == 1 && count_edges(automaton.transitions()) == 0;
  return true;
}

TEST(LtlToBuchi, AgreesWithTheDefinitionOnAllSmallPairs) {
  ltl::Arena arena;
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const Automaton general = ltl_to_tgba(f), buchi = ltl_to_buchi(f);
    ASSERT_TRUE(marks_are_on_states(buchi)) << show(f);
    ASSERT_TRUE(is_trimmed(general) && is_trimmed(buchi)) << show(f);
    for (const Lasso& word : words) {
      ASSERT_TRUE(agree(f, general, word)) << "generalised";
      ASSERT_TRUE(agree(f, buchi, word)) << "Büchi";
    }
  });
}

// The tableau alone, before any reduction and any other route can hide what it does.
TEST(Tableau, AgreesWithTheDefinitionOnAllSmallPairs) {
  ltl::Arena arena;
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const auto reads = ltl::propositions(f);
    Budget budget;
    const Automaton raw = as_automaton(tableau(ltl::nnf(f), reads, budget).automaton, arena.vocabulary(), reads);
    for (const Lasso& word : words) ASSERT_TRUE(agree(f, raw, word));
  });
}

TEST(LtlToBuchi, AgreesWithTheDefinitionOnRandomPairs) {
  constexpr std::uint64_t seed = 20261121;
  ltl::Random random(seed);
  for (int i = 0; i < 400; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 8 + random.below(14), .atoms = 3});
    const Automaton general = ltl_to_tgba(f), buchi = ltl_to_buchi(f);
    for (int j = 0; j < 40; ++j) {
      const Lasso word =
          ltl::random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = 3});
      ASSERT_TRUE(agree(f, general, word)) << "generalised, seed " << seed << ", formula " << i;
      ASSERT_TRUE(agree(f, buchi, word)) << "Büchi, seed " << seed << ", formula " << i;
    }
  }
}

TEST(LtlToBuchi, AFormulaAndItsNegationShareNoWord) {
  constexpr std::uint64_t seed = 8;
  ltl::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    Formula f = ltl::random_formula(random, arena, {.size = 8 + random.below(12), .atoms = 3});
    for (const char* name : {"a", "b", "c"})  // both sides read the same propositions
      f = conjunction(f, disjunction(arena.atom(name), negate(arena.atom(name))));
    const auto reads = ltl::propositions(f);
    Budget budget;
    const TransitionRelation yes =
        reduce(tableau(ltl::nnf(f), reads, budget).automaton, MarksOn::Edges, budget).automaton;
    const TransitionRelation no =
        reduce(tableau(ltl::nnf(negate(f)), reads, budget).automaton, MarksOn::Edges, budget).automaton;
    ASSERT_TRUE(is_empty(intersection(yes, no, budget))) << show(f) << " seed " << seed << ", formula " << i;
  }
}

TEST(LtlToBuchi, HasTheSizesThatTheTheoryKnows) {
  const struct {
    const char* formula;
    std::size_t states, edges, sets, buchi_states;
  } table[] = {
      {"true", 1, 1, 0, 1},
      {"false", 1, 0, 0, 1},
      {"G a", 1, 1, 0, 1},
      {"F a", 2, 3, 1, 2},
      {"G F a", 1, 2, 1, 2},
      {"G F a & G F b", 1, 4, 2, 3},
      {"F G a", 2, 3, 1, 2},
      {"G(a -> F b)", 2, 4, 1, 2},
      {"F G a | G F b", 2, 4, 1, 3},
      {"a U (b U c)", 3, 6, 1, 3},
      {"G(a & X F(b & X F(c & X F d)))", 1, 8, 3, 4},
  };
  for (const auto& row : table) {
    ltl::Arena arena;
    const Formula f = ltl::parse(row.formula, arena);
    const Automaton general = ltl_to_tgba(f);
    EXPECT_EQ(general.states(), row.states) << row.formula;
    EXPECT_EQ(count_edges(general.transitions()), row.edges) << row.formula;
    EXPECT_EQ(general.acceptance().sets, row.sets) << row.formula;
    EXPECT_EQ(ltl_to_buchi(f).states(), row.buchi_states) << row.formula;
  }
}

// Edges would be 3^14: nothing may enumerate them.
TEST(LtlToBuchi, DeterministicObligationsStaySymbolic) {
  std::string text = "F p1";
  for (int i = 2; i <= 12; ++i) text += " & F p" + std::to_string(i);
  ltl::Arena arena;
  const Automaton automaton = ltl_to_tgba(ltl::parse(text, arena));
  EXPECT_EQ(automaton.states(), 4096U);
  EXPECT_TRUE(is_deterministic(automaton.transitions()));
}

TEST(LtlToBuchi, GivesUpWithinItsLimits) {
  ltl::Arena arena;
  const Formula f = ltl::parse("G F(a & X X X X X X b) & G F(c & X X X X X X d)", arena);
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_tgba(f, {.states = 10})));
  std::stop_source source;
  source.request_stop();
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_tgba(f, {.stop = source.get_token()})));
}

}  // namespace
}  // namespace waymark::automata
