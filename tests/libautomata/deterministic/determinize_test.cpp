// Deterministic automata of formulas against the definition: every small formula on every small lasso, then seeded
// random larger pairs; determinism is looked at, and languages are compared with the generalised Büchi automaton.
#include "libautomata/deterministic/determinize.hpp"

#include <gtest/gtest.h>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/limits.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Lasso;
using testing::show;

Automaton only(const std::variant<Translated, Exhausted>& result) { return std::get<Translated>(result).automaton; }

::testing::AssertionResult agree(Formula f, const Automaton& automaton, const Lasso& word) {
  if (accepts(automaton, word) == ltl::holds(word, f)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << show(f, word) << " holds: " << ltl::holds(word, f);
}

// The construction alone, before any reduction and any other route can hide what it does.
TransitionRelation bare(Formula f, const std::vector<ltl::Proposition>& reads) {
  Budget budget;
  return determinize(tableau(ltl::nnf(f), reads, budget).automaton, budget);
}

struct Forms {
  Automaton parity, rabin, generic;
};
Forms forms(Formula f) {
  const ltl::Limits limits;
  return {only(ltl_to_parity(f, limits)), only(ltl_to_rabin(f, limits)), only(ltl_to_generic(f, limits))};
}

::testing::AssertionResult well_formed(Formula f, const Forms& made) {
  if (!Dpa::checked(made.parity)) return ::testing::AssertionFailure() << show(f) << ": no parity automaton";
  for (const Automaton* automaton : {&made.parity, &made.rabin, &made.generic}) {
    if (!is_deterministic(automaton->transitions())) return ::testing::AssertionFailure() << show(f);
    if (automaton->states() != trim(automaton->transitions()).states())
      return ::testing::AssertionFailure() << show(f) << ": not trimmed";
  }
  return ::testing::AssertionSuccess();
}

TEST(Determinize, AgreesWithTheDefinitionOnAllSmallPairs) {
  ltl::Arena arena;
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const auto reads = ltl::propositions(f);
    const TransitionRelation made = bare(f, reads);
    ASSERT_TRUE(is_deterministic(made)) << show(f);
    const Automaton automaton = as_automaton(made, arena.vocabulary(), reads);
    for (const Lasso& word : words) ASSERT_TRUE(agree(f, automaton, word));
  });
}

TEST(Determinize, AgreesWithTheDefinitionOnRandomPairs) {
  constexpr std::uint64_t seed = 41;
  ltl::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 6 + random.below(10), .atoms = 3});
    const auto reads = ltl::propositions(f);
    const Automaton automaton = as_automaton(bare(f, reads), arena.vocabulary(), reads);
    for (int j = 0; j < 60; ++j) {
      const Lasso word =
          ltl::random_lasso(random, {.prefix = random.below(5), .cycle = 1 + random.below(5), .atoms = 3});
      ASSERT_TRUE(agree(f, automaton, word)) << "seed " << seed << ", formula " << i;
    }
  }
}

TEST(LtlToParity, AgreesWithTheDefinitionOnAllSmallPairs) {
  ltl::Arena arena;
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const Forms made = forms(f);
    ASSERT_TRUE(well_formed(f, made));
    for (const Lasso& word : words) {
      ASSERT_TRUE(agree(f, made.parity, word)) << "parity";
      ASSERT_TRUE(agree(f, made.rabin, word)) << "Rabin";
      ASSERT_TRUE(agree(f, made.generic, word)) << "generic";
    }
  });
}

// Equality of languages is decided: the three, and the generalised Büchi automata of φ and ¬φ.
TEST(LtlToParity, HasTheLanguageOfTheTableauOnRandomFormulas) {
  constexpr std::uint64_t seed = 20261121;
  ltl::Random random(seed);
  for (int i = 0; i < (testing::sanitized ? 80 : 300); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 8 + random.below(14), .atoms = 3});
    const Forms made = forms(f);
    ASSERT_TRUE(well_formed(f, made));
    const Automaton yes = ltl_to_tgba(f), no = ltl_to_tgba(ltl::negate(f));
    Budget budget;
    for (const Automaton* automaton : {&made.parity, &made.rabin, &made.generic}) {
      const Automaton outside = complement(*Deterministic::checked(*automaton)).automaton();
      ASSERT_TRUE(is_empty(intersection(*automaton, no, budget).transitions()))
          << show(f) << " accepts too much; seed " << seed << ", formula " << i;
      ASSERT_TRUE(is_empty(intersection(yes, outside, budget).transitions()))
          << show(f) << " accepts too little; seed " << seed << ", formula " << i;
    }
    for (int j = 0; j < 20; ++j) {
      const Lasso word =
          ltl::random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = 3});
      ASSERT_EQ(referee::accepts(made.parity, word), ltl::holds(word, f)) << show(f, word);
    }
  }
}

TEST(LtlToParity, HasTheSizesThatTheTheoryKnows) {
  const struct {
    const char* formula;
    std::size_t states;
    const char* acceptance;
  } table[] = {
      {"true", 1, "all"},
      {"F a", 2, "co-Buchi"},
      {"G F a", 1, "Buchi"},
      {"F G a", 1, "co-Buchi"},
      {"G(a -> F b)", 2, "Buchi"},
      {"a U (b U c)", 3, "co-Buchi"},
      {"F G a | G F b", 1, "parity min even 2"},
      {"G F a & F G b", 1, "Rabin 1"},
      {"F a & F b", 4, "co-Buchi"},
      {"(G F a -> G F b) & (G F c -> G F d)", 2, "parity min even 4"},
      {"G F a <-> G F b", 2, "parity min even 2"},
      {"F a & G F(b & X(c & X d))", 5, "Buchi"},
      {"F a | G b", 3, "co-Buchi"},
  };
  for (const auto& row : table) {
    ltl::Arena arena;
    const Dpa dpa = ltl_to_dpa(ltl::parse(row.formula, arena));
    EXPECT_EQ(dpa.automaton().states(), row.states) << row.formula;
    EXPECT_EQ(dpa.automaton().acceptance().name(), row.acceptance) << row.formula;
  }
}

TEST(LtlToParity, GivesUpWithinItsLimits) {
  ltl::Arena arena;
  const Formula f = ltl::parse("(G F(a & X b) | F G c) & (G F(c & X a) | F G b)", arena);
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_parity(f, {.states = 2})));
  std::stop_source source;
  source.request_stop();
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_parity(f, {.stop = source.get_token()})));
}

TEST(LtlToParity, NondeterministicAutomataAreNoDpa) {
  ltl::Arena arena;
  EXPECT_FALSE(Dpa::checked(ltl_to_tgba(ltl::parse("F G a", arena))));
  EXPECT_TRUE(Dpa::checked(ltl_to_tgba(ltl::parse("G F a", arena))));
  EXPECT_FALSE(Dpa::checked(ltl_to_tgba(ltl::parse("G F a & G F b", arena))));
}

// What trees of braces cannot do within so many states, the normal form in Δ₂ can: its parts are small.
TEST(LtlToParity, TheNormalFormAnswersWhereDeterminisationDoesNot) {
  const struct {
    const char* formula;
    std::size_t states;
  } table[] = {
      {"F F !F(((!p1 W p3) U (G((G p2 ^ F p3) M (X !p0)))) R (p2 M p1))", 10},
      {"!G G F((X p2 & X F(p1 ^ G p0)) <-> ((F(p0 <-> p3)) U (G F(p1 W (p0 R p3)))))", 20},  // 11 by g++, 12 by clang
  };
  ltl::Random random(82);
  for (const auto& row : table) {
    ltl::Arena arena(ltl::Vocabulary({"p0", "p1", "p2", "p3"}));
    const ltl::Formula f = ltl::parse(row.formula, arena);
    const auto found = ltl_to_parity(f, {.states = 300});
    const auto* made = std::get_if<Translated>(&found);
    ASSERT_NE(made, nullptr) << row.formula;
    EXPECT_LE(made->automaton.states(), row.states) << row.formula;
    for (int i = 0; i < 200; ++i) {
      const ltl::Lasso word =
          ltl::random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(4), .atoms = 4});
      ASSERT_EQ(accepts(made->automaton, word), ltl::holds(word, f)) << testing::show(f, word);
    }
  }
}

}  // namespace
}  // namespace waymark::automata
