// Folding: the language stays, by definition on lassos; nothing foldable is left, by a product of its own.
#include "libautomata/omega/state_merging.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

class Fold : public ::testing::Test {
 protected:
  TransitionRelation reduced_tableau(Formula f) {
    return reduce(tableau(ltl::nnf(f), reads_, budget_).automaton, MarksOn::Edges, budget_).automaton;
  }
  ::testing::AssertionResult accepts_the_words_of(Formula f, const TransitionRelation& transitions) {
    const Automaton automaton = as_automaton(transitions, arena_.vocabulary(), reads_);
    for (const ltl::Lasso& word : words_)
      if (accepts(automaton, word) != ltl::holds(word, f))
        return ::testing::AssertionFailure() << testing::show(f, word) << " holds: " << ltl::holds(word, f);
    return ::testing::AssertionSuccess();
  }
  // Two states that could be one still.
  ::testing::AssertionResult is_folded_up(const TransitionRelation& automaton, const TransitionRelation& outside) {
    for (std::uint32_t c = 1; c < automaton.states(); ++c)
      for (std::uint32_t d = 0; d < c; ++d) {
        std::vector<std::uint32_t> name(automaton.states());
        std::iota(name.begin(), name.end(), 0U);
        name[c] = d;
        if (is_empty(intersection(united(automaton, name, budget_), outside, budget_)))
          return ::testing::AssertionFailure() << "states " << c << " and " << d;
      }
    return ::testing::AssertionSuccess();
  }

  const std::vector<ltl::Proposition> reads_{{0}, {1}};
  const std::vector<ltl::Lasso> words_ = testing::all_lassos({.length = 3, .atoms = 2});
  ltl::Arena arena_{testing::letters_vocabulary(2)};
  Budget budget_;
};

// F G φ ∨ G F ψ and φ ∨ G F ψ, for small φ and ψ.
TEST_F(Fold, KeepsTheLanguageOfSmallFormulas) {
  std::size_t smaller = 0, smaller_on_states = 0;
  const auto small = testing::all_formulas(arena_, {.size = 3, .atoms = 2});
  const std::size_t step = testing::sanitized ? 101 : 11;
  for (std::size_t i = 0; i < small.size() * small.size(); i += step) {
    const Formula left = small[i % small.size()], right = small[i / small.size()];
    const Formula f =
        ltl::disjunction(i % 2 == 0 ? left : ltl::eventually(ltl::always(left)), ltl::always(ltl::eventually(right)));
    const TransitionRelation general = reduced_tableau(f), outside = reduced_tableau(negate(f));
    const Reduced made = state_merged(general, outside, MarksOn::Edges, budget_);
    EXPECT_TRUE(made.complete);
    ASSERT_TRUE(accepts_the_words_of(f, made.automaton));
    ASSERT_TRUE(is_folded_up(made.automaton, outside)) << testing::show(f);
    smaller += made.automaton.states() < general.states() ? 1 : 0;
    const TransitionRelation levels =
        reduce(degeneralize(general, {.look_ahead = true}, budget_), MarksOn::States, budget_).automaton;
    const TransitionRelation on_states = state_merged(levels, outside, MarksOn::States, budget_).automaton;
    ASSERT_TRUE(accepts_the_words_of(f, on_states));
    smaller_on_states += on_states.states() < levels.states() ? 1 : 0;
  }
  EXPECT_GT(smaller, testing::sanitized ? 2U : 20U);
  EXPECT_GT(smaller_on_states, testing::sanitized ? 0U : 5U);
}

TEST_F(Fold, KeepsTheLanguageOfRandomFormulas) {
  constexpr std::uint64_t seed = 11;
  ltl::Random random(seed);
  std::size_t smaller = 0;
  for (int i = 0; i < (testing::sanitized ? 40 : 400); ++i) {
    const Formula f = ltl::nnf(ltl::random_formula(random, arena_, {.size = 14, .atoms = 2}));
    const TransitionRelation general = reduced_tableau(f), outside = reduced_tableau(negate(f));
    if (general.states() > 30) continue;
    const Reduced made = state_merged(general, outside, MarksOn::Edges, budget_);
    ASSERT_TRUE(accepts_the_words_of(f, made.automaton)) << "seed " << seed << ", formula " << i;
    ASSERT_TRUE(is_folded_up(made.automaton, outside)) << testing::show(f);
    smaller += made.automaton.states() < general.states() ? 1 : 0;
  }
  EXPECT_GT(smaller, testing::sanitized ? 2U : 20U);
}

// Marks stay on states: all branches of a state carry them, or none does.
TEST_F(Fold, StatesWithAndWithoutMarksAreNotMixed) {
  ltl::Random random(12);
  for (int i = 0; i < (testing::sanitized ? 20 : 200); ++i) {
    const Formula f = ltl::nnf(ltl::random_formula(random, arena_, {.size = 14, .atoms = 2}));
    const TransitionRelation levels = degeneralize(reduced_tableau(f), {.look_ahead = true}, budget_);
    if (levels.states() > 40) continue;
    const TransitionRelation out = state_merged(levels, reduced_tableau(negate(f)), MarksOn::States, budget_).automaton;
    ASSERT_TRUE(accepts_the_words_of(f, out));
    const std::vector<bool> marked = marked_states(out);
    for (std::uint32_t q = 0; q < out.states(); ++q)
      for (const Branch& b : branches_of(out, q)) ASSERT_EQ(!b.marks.empty(), marked[q]) << testing::show(f);
  }
}

// Who waits for the moment from which on a holds may as well count the b on the way.
TEST_F(Fold, AStateThatWaitsTakesInAComponent) {
  const Formula f = ltl::parse("F G a | G F b", arena_);
  const TransitionRelation before = reduced_tableau(f), outside = reduced_tableau(negate(f));
  EXPECT_EQ(before.states(), 3U);
  EXPECT_EQ(state_merged(before, outside, MarksOn::Edges, budget_).automaton.states(), 2U);
}

TEST_F(Fold, WithoutEffortTheAutomatonIsValidAndSaysSo) {
  const Formula f = ltl::parse("F G a | G F b", arena_);
  const TransitionRelation before = reduced_tableau(f), outside = reduced_tableau(negate(f));
  std::size_t complete = 0, cut_short = 0;
  for (std::size_t steps = 0; steps < 1000; steps += 5) {
    Budget little(steps, SIZE_MAX, {});
    const Reduced made = state_merged(before, outside, MarksOn::Edges, little);
    ASSERT_TRUE(accepts_the_words_of(f, made.automaton)) << steps << " steps";
    ++(made.complete ? complete : cut_short);
  }
  EXPECT_GT(complete, 0U);
  EXPECT_GT(cut_short, 0U);
}

// F a with a state too many, and G !a as a cycle of states, one more than two words of bits have.
TEST_F(Fold, TheComplementMayHaveManyStates) {
  TransitionRelation inside, outside;
  inside.acceptance = outside.acceptance = Acceptance::buchi();
  const auto go = [](TransitionRelation& automaton, std::uint32_t target, Marks marks) {
    return Mtbdd::terminal(automaton.choices.intern({{target, marks}}));
  };
  for (std::uint32_t q = 0; q < 2; ++q)
    inside.roots.push_back(inside.diagram.make(0, go(inside, 1, {}), go(inside, 2, {})));
  inside.roots.push_back(go(inside, 2, Marks::of(0)));
  constexpr std::uint32_t many = 129;
  for (std::uint32_t q = 0; q < many; ++q)
    outside.roots.push_back(
        outside.diagram.make(0, go(outside, (q + 1) % many, Marks::of(0)), Mtbdd::terminal(Choices::none)));
  const Reduced made = state_merged(inside, outside, MarksOn::Edges, budget_);
  EXPECT_TRUE(made.complete);
  EXPECT_EQ(made.automaton.states(), 2U);
  EXPECT_TRUE(accepts_the_words_of(ltl::parse("F a", arena_), made.automaton));
}

}  // namespace
}  // namespace waymark::automata
