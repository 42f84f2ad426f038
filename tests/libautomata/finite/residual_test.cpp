// Residuals against progression: what is left, and whether the word may stop, are told apart.
#include "libautomata/finite/residual.hpp"

#include <gtest/gtest.h>

#include <set>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/run.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

class Residual : public ::testing::Test {
 protected:
  // After a letter with a the rest may be empty, after one without it may not; either way it satisfies ψ otherwise.
  Formula may_stop_after_a(Formula psi) {
    const Formula a = arena_.atom(ltl::Proposition{0});
    return ltl::disjunction(ltl::conjunction(a, ltl::weak_next(psi)), ltl::conjunction(ltl::negate(a), ltl::next(psi)));
  }

  const std::vector<ltl::Proposition> reads_{{0}, {1}};
  ltl::Arena arena_{testing::letters_vocabulary(2)};
  Budget budget_;
};

TEST_F(Residual, OneResidualIsTwoStatesWhereTheWordMayStopAndWhereNot) {
  const auto traces = testing::all_traces({.length = 4, .atoms = 2});
  std::size_t told_apart = 0;
  for (const Formula psi : testing::all_formulas(arena_, {.size = testing::sanitized ? 3U : 4U, .atoms = 2})) {
    const Formula f = may_stop_after_a(psi);
    const Dfa dfa = ltlf_to_dfa(f);
    for (const ltl::Trace& word : traces) ASSERT_EQ(accepts(dfa, word), ltl::holds(word, f)) << testing::show(f, word);
    Residuals residuals(f, reads_, budget_);
    std::vector<std::uint32_t> order;
    const Transitions closed = close(residuals, ltl::Semantics::Finite, order, budget_);
    std::set<std::pair<std::uint32_t, bool>> leaves;
    std::set<std::uint32_t> rests;
    for (std::size_t q = 0; q < order.size(); ++q) {
      const Residuals::Leaf& leaf = residuals.leaf(order[q]);
      ASSERT_TRUE(leaves.insert({leaf.residual.id, leaf.may_stop}).second) << "twice the same state: " << ltl::print(f);
      ASSERT_EQ(closed.accepting[q], leaf.may_stop) << ltl::print(f);
      rests.insert(leaf.residual.id);
    }
    told_apart += rests.size() < leaves.size() ? 1 : 0;
  }
  EXPECT_GT(told_apart, testing::sanitized ? 10U : 50U);
}

// Every state stands for what progression leaves: the same words accepted from there, of every rest.
TEST_F(Residual, LeavesAreWhatProgressionLeaves) {
  const auto rests = testing::all_traces({.length = 3, .atoms = 2});
  const auto letters = testing::all_traces({.length = 1, .atoms = 2});
  for (const Formula psi : testing::all_formulas(arena_, {.size = 3, .atoms = 2})) {
    const Formula f = may_stop_after_a(psi);
    Residuals residuals(f, reads_, budget_);
    const Mtbdd::Node successors = residuals.successors(residuals.initial());
    for (const ltl::Trace& one : letters) {
      const auto holds = [&](Mtbdd::Variable v) { return one[0].contains(reads_[v]); };
      const Mtbdd::Node terminal = residuals.diagram().evaluate(successors, holds);
      const Residuals::Leaf& leaf = residuals.leaf(Mtbdd::payload(terminal));
      ASSERT_EQ(leaf.may_stop, ltl::holds(one, f)) << testing::show(f, one);
      const Formula left = residuals.formula(leaf.residual, arena_), progressed = ltl::progress(f, one[0]);
      for (const ltl::Trace& rest : rests)
        ASSERT_EQ(ltl::holds(rest, left), ltl::holds(rest, progressed))
            << ltl::print(f) << " leaves " << ltl::print(left) << ": " << testing::show(progressed, rest);
    }
  }
}

// Over infinite words no word stops: one residual is one state, and no state accepts.
TEST_F(Residual, InfiniteWordsDoNotStop) {
  std::size_t fewer = 0;
  for (const Formula psi : testing::all_formulas(arena_, {.size = 3, .atoms = 2})) {
    const Formula f = may_stop_after_a(psi);
    Residuals residuals(f, reads_, budget_);
    std::vector<std::uint32_t> order;
    const Transitions closed = close(residuals, ltl::Semantics::Infinite, order, budget_);
    std::set<std::uint32_t> rests;
    for (const std::uint32_t leaf : order)
      ASSERT_TRUE(rests.insert(residuals.leaf(leaf).residual.id).second) << ltl::print(f);
    ASSERT_EQ(closed.roots.size(), order.size());
    Residuals of_finite_words(f, reads_, budget_);
    std::vector<std::uint32_t> leaves;
    fewer += close(of_finite_words, ltl::Semantics::Finite, leaves, budget_).roots.size() > order.size() ? 1 : 0;
    for (const bool accepting : closed.accepting) ASSERT_FALSE(accepting) << ltl::print(f);
  }
  EXPECT_GT(fewer, 10U);
}

}  // namespace
}  // namespace waymark::automata
