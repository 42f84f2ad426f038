// Names of states mean nothing: what is made of an automaton whose states are numbered at random, so that the initial
// state is seldom the first, has the same words by definition, and the same number of states where that number is
// determined.
#include <gtest/gtest.h>

#include <numeric>

#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libautomata/omega/state_merging.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libautomata/omega/without_fin.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

class Numbering : public ::testing::Test {
 protected:
  TransitionRelation tableau_of(Formula f) { return tableau(ltl::nnf(f), reads_, budget_).automaton; }

  // The same automaton with its states in another order.
  TransitionRelation renumbered(const TransitionRelation& automaton) {
    std::vector<std::uint32_t> kept(automaton.states());
    std::iota(kept.begin(), kept.end(), 0U);
    for (std::size_t i = kept.size(); i > 1; --i) std::swap(kept[i - 1], kept[random_.below(i)]);
    std::vector<std::uint32_t> number(kept.size());
    for (std::uint32_t i = 0; i < kept.size(); ++i) number[kept[i]] = i;
    TransitionRelation out = rebuild(automaton, kept, [&](std::uint32_t, std::span<const Branch> choice) {
      std::vector<Branch> branches(choice.begin(), choice.end());
      for (Branch& b : branches) b.target = number[b.target];
      return branches;
    });
    out.initial = number[automaton.initial];
    first_elsewhere_ += out.initial != 0 ? 1 : 0;
    return out;
  }

  void expect_words_of(Formula f, const TransitionRelation& transitions, const char* what) {
    const Automaton automaton = as_automaton(transitions, arena_.vocabulary(), reads_);
    for (const ltl::Lasso& word : words_)
      ASSERT_EQ(accepts(automaton, word), ltl::holds(word, f)) << what << ": " << testing::show(f, word);
  }

  const std::vector<ltl::Proposition> reads_{{0}, {1}};
  const std::vector<ltl::Lasso> words_ = testing::all_lassos({.length = 3, .atoms = 2});
  ltl::Arena arena_{testing::letters_vocabulary(2)};
  ltl::Random random_{16};
  Budget budget_;
  std::size_t first_elsewhere_ = 0;
};

TEST_F(Numbering, LeavesWordsAndSizes) {
  const int formulas = testing::sanitized ? 10 : 60;
  std::size_t merged = 0;
  for (int i = 0; i < formulas; ++i) {
    const Formula f = ltl::nnf(ltl::random_formula(random_, arena_, {.size = 11, .atoms = 2}));
    const TransitionRelation plain = tableau_of(f);
    if (plain.states() > 24) continue;
    const TransitionRelation mixed = renumbered(plain);
    expect_words_of(f, mixed, "renumbered");
    EXPECT_EQ(is_empty(mixed), is_empty(plain)) << ltl::print(f);

    const TransitionRelation classes = bisimulation_quotient(mixed, budget_);
    expect_words_of(f, classes, "bisimulation");
    EXPECT_EQ(classes.states(), bisimulation_quotient(plain, budget_).states()) << ltl::print(f);

    Simulations forwards(mixed, budget_), backwards(mixed, budget_), before(plain, budget_);
    const TransitionRelation simulated = forwards.quotient();
    expect_words_of(f, simulated, "simulation");
    EXPECT_EQ(simulated.states(), before.quotient().states()) << ltl::print(f);
    expect_words_of(f, backwards.reverse_quotient(std::vector<bool>(mixed.states(), false)), "reverse simulation");
    expect_words_of(f, backwards.without_overtaken(), "overtaken branches");

    expect_words_of(f, trim(mixed), "trimmed");
    expect_words_of(f, scc_filter(mixed, MarksOn::Edges, budget_), "filtered");
    expect_words_of(f, reduce(mixed, MarksOn::Edges, budget_).automaton, "reduced");
    expect_words_of(f, reduce_as_marked(mixed, budget_).automaton, "reduced as marked");
    expect_words_of(f, without_fin(mixed, budget_), "without Fin");
    if (const auto freed = with_free_marks(mixed)) expect_words_of(f, *freed, "free marks");
    const TransitionRelation levels = degeneralize(mixed, {.look_ahead = true}, budget_);
    expect_words_of(f, levels, "degeneralised");
    expect_words_of(f, reduce(renumbered(levels), MarksOn::States, budget_).automaton, "reduced, marks on states");

    const TransitionRelation outside = renumbered(tableau_of(negate(f)));
    EXPECT_TRUE(is_empty(intersection(mixed, outside, budget_))) << ltl::print(f);
    if (outside.states() > 24) continue;
    const TransitionRelation small = state_merged(mixed, outside, MarksOn::Edges, budget_).automaton;
    expect_words_of(f, small, "states merged");
    merged += small.states() < reduce(mixed, MarksOn::Edges, budget_).automaton.states() ? 1 : 0;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(first_elsewhere_, static_cast<std::size_t>(formulas) / 2);
  EXPECT_GT(merged, 0U);
}

// The merging without what reduces the automaton before and after: the initial state is any of three.
TEST_F(Numbering, LeavesTheMergingThatAWaitingStateAllows) {
  const Formula f = ltl::disjunction(ltl::eventually(ltl::always(arena_.atom(ltl::Proposition{0}))),
                                     ltl::always(ltl::eventually(arena_.atom(ltl::Proposition{1}))));
  const TransitionRelation plain = reduce(tableau_of(f), MarksOn::Edges, budget_).automaton;
  const TransitionRelation outside = reduce(tableau_of(negate(f)), MarksOn::Edges, budget_).automaton;
  ASSERT_EQ(plain.states(), 3U);
  for (int i = 0; i < 30; ++i) {
    const TransitionRelation merged =
        state_merged(renumbered(plain), renumbered(outside), MarksOn::Edges, budget_).automaton;
    expect_words_of(f, merged, "merged");
    EXPECT_EQ(merged.states(), 2U) << "numbering " << i;
  }
  EXPECT_GT(first_elsewhere_, 20U);
}

}  // namespace
}  // namespace waymark::automata
