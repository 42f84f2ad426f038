// The parts that the translation is put together from, each against the definition on all small lassos.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "libautomata/omega/automaton.hpp"
#include "libautomata/omega/containment.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libautomata/omega/recurrence.hpp"
#include "libautomata/omega/suspension.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libautomata/omega/weak.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/separate.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using testing::show;

class Routes : public ::testing::Test {
 protected:
  // Both propositions, whatever the formula reads: automata of several formulas share their variables.
  const std::vector<ltl::Proposition> reads_{{0}, {1}};
  const std::vector<ltl::Lasso> words_ = testing::all_lassos({.length = 3, .atoms = 2});
  ltl::Arena arena_{testing::letters_vocabulary(2)};
  Budget budget_;

  TransitionRelation tableau_of(Formula f) { return tableau(ltl::nnf(f), reads_, budget_).automaton; }
  ::testing::AssertionResult accepts_the_words_of(Formula f, const TransitionRelation& transitions) {
    const Automaton automaton = as_automaton(transitions, arena_.vocabulary(), reads_);
    for (const ltl::Lasso& word : words_)
      if (accepts(automaton, word) != ltl::holds(word, f))
        return ::testing::AssertionFailure() << show(f, word) << " holds: " << ltl::holds(word, f);
    return ::testing::AssertionSuccess();
  }
};

TEST_F(Routes, TheWeakAutomatonOfAnObligationHasItsLanguage) {
  std::size_t obligations = 0;
  testing::for_each_formula(arena_, {.size = 4, .atoms = 2}, [&](Formula f) {
    if (!ltl::fragments(f, ltl::Semantics::Infinite).obligation) return;
    ++obligations;
    const Transitions weak = weak_deterministic(f, reads_, budget_);
    ASSERT_TRUE(accepts_the_words_of(f, as_buchi(weak, {})));
    ASSERT_TRUE(accepts_the_words_of(negate(f), as_buchi(weak, {.complement = true})));
  });
  EXPECT_GT(obligations, 400U);
}

TEST_F(Routes, ADeterministicBuchiAutomatonIsFoundWhereTheStructureCarriesIt) {
  for (const char* text : {"G F a", "G(a -> F b)", "G(a | F(b & X a))", "a U b", "G(a -> X F b)"}) {
    const Formula f = ltl::parse(text, arena_);
    const auto found =
        deterministic_buchi(progression(f, reads_, budget_), tableau_of(f), tableau_of(negate(f)), budget_);
    ASSERT_TRUE(found) << text;
    EXPECT_TRUE(is_deterministic(*found)) << text;
    EXPECT_TRUE(accepts_the_words_of(f, *found));
  }
  for (const char* text : {"F G a", "F G a | G F b", "G F a & G F b"}) {  // the last one would have to count
    const Formula f = ltl::parse(text, arena_);
    EXPECT_FALSE(deterministic_buchi(progression(f, reads_, budget_), tableau_of(f), tableau_of(negate(f)), budget_))
        << text;
  }
}

TEST_F(Routes, WhatConcernsTheFarEndMayStartLate) {
  for (const char* late : {"G F a", "F G b", "G F a & F G(a | b)", "G F(a & X b)"})
    testing::for_each_formula(arena_, {.size = 3, .atoms = 2}, [&](Formula f) {
      const Formula q = ltl::parse(late, arena_);
      ASSERT_TRUE(ltl::purity(q).both()) << late;
      ASSERT_TRUE(accepts_the_words_of(conjunction(f, q), compose_late(tableau_of(f), tableau_of(q), budget_)));
    });
}

TEST_F(Routes, RestartingReadsGoodPrefixesForEver) {
  for (const char* text : {"F a", "F(a & X b)", "F(a & X(b & X a))", "F(a & F b)"}) {
    const Formula e = ltl::parse(text, arena_);
    const auto again = restarted(as_buchi(weak_deterministic(e, reads_, budget_), {}));
    ASSERT_TRUE(again) << text;
    EXPECT_TRUE(accepts_the_words_of(ltl::always(e), *again));
  }
  const Formula persistent = ltl::parse("F G a", arena_);  // not co-safe: some runs accept elsewhere
  EXPECT_FALSE(restarted(tableau_of(persistent)));
  EXPECT_FALSE(restarted(tableau_of(ltl::parse("G a", arena_))));  // its one state accepts, and is left by !a
}

// By reachability alone: the component of the new initial state leads nowhere else, and no such component is smaller.
TEST_F(Routes, StartedInsideIsInASmallestComponentThatNothingLeaves) {
  ltl::Random random(41);
  std::size_t moved = 0, several = 0;
  for (int i = 0; i < 3'000; ++i) {
    const TransitionRelation given =
        random_automaton(random, arena_.vocabulary(), {.states = 12, .branches = 1, .empty = 0.6}).transitions();
    const TransitionRelation made = started_inside(given);
    std::vector<std::set<std::uint32_t>> reached(given.states());
    for (std::uint32_t q = 0; q < given.states(); ++q) {
      reached[q].insert(q);
      for (std::vector<std::uint32_t> stack{q}; !stack.empty();) {
        const std::uint32_t r = stack.back();
        stack.pop_back();
        for (const Branch& b : branches_of(given, r))
          if (reached[q].insert(b.target).second) stack.push_back(b.target);
      }
    }
    std::set<std::set<std::uint32_t>> bottoms;
    std::size_t least = SIZE_MAX;
    for (const auto& from : reached)
      if (std::all_of(from.begin(), from.end(), [&](std::uint32_t r) { return reached[r] == from; })) {
        bottoms.insert(from);
        least = std::min(least, from.size());
      }
    EXPECT_TRUE(bottoms.contains(reached[made.initial])) << i;
    EXPECT_EQ(reached[made.initial].size(), least) << i;
    EXPECT_EQ(made.roots, given.roots) << i;
    moved += made.initial != given.initial ? 1 : 0;
    several += std::any_of(bottoms.begin(), bottoms.end(), [&](const auto& b) { return b.size() > least; }) ? 1 : 0;
  }
  EXPECT_GT(moved, 100U);
  EXPECT_GT(several, 20U);
}

// Small formulas that no lasso of three letters tells apart do imply each other.
TEST_F(Routes, ContainmentIsImplicationOnEveryWord) {
  Containment implies(reads_, budget_);
  std::size_t found = 0;
  const auto formulas = testing::all_formulas(arena_, {.size = 3, .atoms = 2});
  for (Formula f : formulas)
    for (Formula g : formulas) {
      bool on_words = true;
      for (const ltl::Lasso& word : words_) on_words = on_words && (!ltl::holds(word, f) || ltl::holds(word, g));
      ASSERT_EQ(implies(f, g), on_words) << show(f) << " and " << show(g);
      found += on_words ? 1 : 0;
    }
  EXPECT_GT(found, formulas.size());
}

TEST_F(Routes, ContainmentSaysNoOnceTheBudgetIsSpent) {
  const Formula f = ltl::parse("a U (b U (a U b))", arena_), g = ltl::parse("F b", arena_);
  EXPECT_TRUE(Containment(reads_, budget_)(f, g));
  Budget none(0, SIZE_MAX, {});
  Containment implies(reads_, none);
  EXPECT_FALSE(implies(f, g)) << "nothing is thrown";
  EXPECT_FALSE(implies(g, g)) << "nor is anything asked again";
  std::stop_source source;
  source.request_stop();
  Budget stopped(4'096, SIZE_MAX, source.get_token());  // a stop is looked for every 4,096 steps
  EXPECT_THROW(Containment(reads_, stopped)(f, g), Budget::Exceeded);
}

}  // namespace
}  // namespace waymark::automata
