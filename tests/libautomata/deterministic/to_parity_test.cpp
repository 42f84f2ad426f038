// From any automaton to generalised Büchi, to deterministic parity and to limit-deterministic Büchi: the same words, by
// the definition of acceptance on all small lassos.
#include "libautomata/deterministic/to_parity.hpp"

#include <gtest/gtest.h>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libautomata/omega/without_fin.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

const ltl::Vocabulary ab({"a", "b"});
const testing::WordSpace small{.length = 3, .atoms = 2};

std::string show(const Automaton& automaton, const ltl::Lasso& word) {
  return write_hoa(automaton) + "on " + ltl::show(word, ab);
}

bool holds(const std::vector<Clause>& all, Marks infinitely_often) {
  for (const Clause& c : all)
    if ((c.finitely & infinitely_often).empty() && infinitely_often.includes(c.infinitely)) return true;
  return false;
}

TEST(WithoutFin, ClausesSayWhatTheConditionSays) {
  ltl::Random random(31);
  for (int i = 0; i < 200; ++i) {
    const Acceptance acceptance =
        random_automaton(random, ab, {.states = 2, .sets = 1 + static_cast<std::uint32_t>(i % 5)}).acceptance();
    Budget budget;
    const std::vector<Clause> all = clauses(acceptance.condition, budget);
    for (std::uint64_t bits = 0; bits < std::uint64_t{1} << acceptance.sets; ++bits)
      ASSERT_EQ(holds(all, Marks::from_bits(bits)), acceptance.condition.holds(Marks::from_bits(bits)))
          << print(acceptance.condition) << " on " << bits;
  }
}

TEST(WithoutFin, ManyClausesSpendTheBudget) {
  std::vector<Condition> pairs;
  for (std::uint32_t pair = 0; pair < 15; ++pair)
    pairs.push_back(Condition::any_of({Condition::fin(2 * pair), Condition::inf(2 * pair + 1)}));
  Budget budget(100'000, SIZE_MAX, {});
  EXPECT_THROW(clauses(Condition::all_of(pairs), budget), Budget::Exceeded);
}

TEST(WithoutFin, KeepsTheLanguage) {
  ltl::Random random(32);
  for (int i = 0; i < testing::scaled(150); ++i) {
    const Automaton from = random_automaton(
        random, ab, {.states = static_cast<std::uint32_t>(1 + i % 4), .sets = static_cast<std::uint32_t>(i % 4)});
    Budget budget;
    const Automaton made = as_automaton(without_fin(from.transitions(), budget), ab, from.reads());
    ASSERT_TRUE(made.acceptance().is_generalized_buchi());
    testing::for_each_lasso(small, [&](const ltl::Lasso& word) {
      ASSERT_EQ(referee::accepts(made, word), referee::accepts(from, word)) << i << '\n' << show(from, word);
    });
  }
}

TEST(ToParity, KeepsTheLanguageOfAnyAutomaton) {
  ltl::Random random(33);
  for (int i = 0; i < testing::scaled(150); ++i) {
    const Automaton from = random_automaton(random, ab,
                                            {.states = static_cast<std::uint32_t>(1 + i % 4),
                                             .sets = static_cast<std::uint32_t>(i % 4),
                                             .branches = 1 + static_cast<std::size_t>(i % 3)});
    Budget budget;
    const Dpa parity = to_parity(from, budget);
    const Deterministic same = determinized(from, budget);
    const Automaton jumping = limit_deterministic(parity).automaton();
    testing::for_each_lasso(small, [&](const ltl::Lasso& word) {
      const bool expected = referee::accepts(from, word);
      ASSERT_EQ(referee::accepts(parity.automaton(), word), expected) << i << '\n' << show(from, word);
      ASSERT_EQ(referee::accepts(same.automaton(), word), expected) << i << '\n' << show(from, word);
      ASSERT_EQ(referee::accepts(jumping, word), expected) << i << '\n' << show(from, word);
    });
  }
}

TEST(ToParity, StopsAtItsLimits) {
  ltl::Random random(34);
  const Automaton from = random_automaton(random, ab, {.states = 6, .sets = 2, .branches = 3});
  Budget budget(10, 2, {});
  EXPECT_THROW(to_parity(from, budget), Budget::Exceeded);
}

}  // namespace
}  // namespace waymark::automata
