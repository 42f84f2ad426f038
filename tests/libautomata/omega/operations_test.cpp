// Boolean operations, alternation and emptiness, against the definition of acceptance on all small lassos.
#include "libautomata/omega/operations.hpp"

#include <gtest/gtest.h>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/random_automaton.hpp"
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

RandomAutomaton shape(int i, std::size_t branches) {
  return {.states = static_cast<std::uint32_t>(1 + i % 4),
          .sets = static_cast<std::uint32_t>(i % 3),
          .branches = branches,
          .empty = i % 2 == 0 ? 0.0 : 0.2,
          .generic = i % 5 != 0};
}

TEST(OmegaOperations, AreTheBooleanOnesOfTheLanguages) {
  ltl::Random random(11);
  for (int i = 0; i < testing::scaled(60); ++i) {
    const Automaton a = random_automaton(random, ab, shape(i, 2)), b = random_automaton(random, ab, shape(i + 1, 2));
    Budget budget;
    const Automaton both = intersection(a, b, budget), any = sum(a, b);
    testing::for_each_lasso(small, [&](const ltl::Lasso& word) {
      const bool p = referee::accepts(a, word), q = referee::accepts(b, word);
      ASSERT_EQ(referee::accepts(both, word), p && q) << i << '\n' << show(a, word) << show(b, word);
      ASSERT_EQ(referee::accepts(any, word), p || q) << i << '\n' << show(a, word) << show(b, word);
    });
  }
}

TEST(OmegaOperations, OfDeterministicAutomataAreDeterministic) {
  ltl::Random random(12);
  for (int i = 0; i < 120; ++i) {
    const auto a = Deterministic::checked(random_automaton(random, ab, shape(i, 1)));
    const auto b = Deterministic::checked(random_automaton(random, ab, shape(i + 1, 1)));
    ASSERT_TRUE(a && b);
    Budget budget;
    const Deterministic any = either(*a, *b, budget), not_a = complement(*a);
    testing::for_each_lasso(small, [&](const ltl::Lasso& word) {
      const bool p = referee::accepts(a->automaton(), word), q = referee::accepts(b->automaton(), word);
      ASSERT_EQ(referee::accepts(any.automaton(), word), p || q) << i;
      ASSERT_EQ(referee::accepts(not_a.automaton(), word), !p) << i << '\n' << show(a->automaton(), word);
    });
  }
}

TEST(OmegaOperations, MatchPropositionsByName) {
  const Automaton a = read_omega_hoa("HOA: v1 Start: 0 AP: 1 \"b\" Acceptance: 0 t --BODY-- State: 0 [0] 0 --END--");
  const Automaton b =
      read_omega_hoa("HOA: v1 Start: 0 AP: 2 \"a\" \"b\" Acceptance: 0 t --BODY-- State: 0 [0&1] 0 --END--");
  Budget budget;
  EXPECT_NE(write_hoa(intersection(a, b, budget)).find("AP: 2 \"b\" \"a\""), std::string::npos);
  EXPECT_NE(write_hoa(intersection(a, b, budget)).find("[0&1] 0"), std::string::npos);
}

TEST(OmegaOperations, AutomataNameThePropositionsThatTheyRead) {
  const Automaton b = read_omega_hoa(
      "HOA: v1 Start: 0 AP: 3 \"a\" \"b\" \"c\" Acceptance: 0 t --BODY-- State: 0 [1] 0 [0&1] 0 --END--");
  EXPECT_NE(write_hoa(b).find("AP: 1 \"b\""), std::string::npos) << write_hoa(b);
}

TEST(OmegaOperations, SumsBeginWhereBothBegin) {
  const auto waits_for = [](const char* proposition) {
    return read_omega_hoa(std::string("HOA: v1 Start: 1 AP: 1 \"") + proposition +
                          "\" Acceptance: 0 t --BODY-- State: 0 [t] 0 State: 1 [!0] 2 State: 2 [0] 0 --END--");
  };
  const Automaton a = waits_for("a"), b = waits_for("b"), any = sum(a, b);
  testing::for_each_lasso(small, [&](const ltl::Lasso& word) {
    const auto first_late = [&](std::uint32_t p) {
      return !word[0].contains(ltl::Proposition{p}) && word[word.successor(0)].contains(ltl::Proposition{p});
    };
    ASSERT_EQ(referee::accepts(any, word), first_late(0) || first_late(1)) << show(any, word);
  });
}

TEST(RandomAutomaton, RefusesWhatNoAutomatonIs) {
  ltl::Random random(14);
  EXPECT_THROW(random_automaton(random, ab, {.states = 0}), std::invalid_argument);
  EXPECT_THROW(random_automaton(random, ab, {.branches = 0}), std::invalid_argument);
  EXPECT_THROW(random_automaton(random, ab, {.atoms = 3}), std::invalid_argument);
  EXPECT_THROW(random_automaton(random, ab, {.sets = Marks::most + 1}), std::invalid_argument);
  EXPECT_EQ(random_automaton(random, ab, {.sets = Marks::most, .generic = false}).acceptance().sets, Marks::most);
}

TEST(OmegaOperations, StopAtTheLimits) {
  ltl::Random random(13);
  const Automaton a = random_automaton(random, ab, {.states = 6, .empty = 0});
  Budget few(SIZE_MAX, 3, {});
  EXPECT_THROW(intersection(a, random_automaton(random, ab, {.states = 6, .empty = 0}), few), Budget::Exceeded);
  Budget any;
  const Automaton many = random_automaton(random, ab, {.sets = 40});
  EXPECT_THROW(intersection(many, many, any), Budget::Exceeded);
  EXPECT_THROW(sum(many, many), std::length_error);
}

TEST(FindLasso, FindsAWordThatIsAcceptedOrThereIsNone) {
  ltl::Random random(14);
  std::size_t empty = 0;
  for (int i = 0; i < 400; ++i) {
    RandomAutomaton options = shape(i, 1 + static_cast<std::size_t>(i % 2));
    options.sets = static_cast<std::uint32_t>(i % 4);
    const Automaton a = random_automaton(random, ab, options);
    const std::optional<ltl::Lasso> word = find_lasso(a);
    if (word) {
      EXPECT_TRUE(referee::accepts(a, *word)) << i << '\n' << show(a, *word);
      continue;
    }
    ++empty;
    testing::for_each_lasso(small, [&](const ltl::Lasso& other) {
      ASSERT_FALSE(referee::accepts(a, other)) << i << '\n' << show(a, other);
    });
  }
  EXPECT_GT(empty, 20U);
  EXPECT_LT(empty, 380U);
}

// Of two ways to avoid marks the one is to meet what the other avoids.
TEST(FindLasso, LeavesOutOneMarkAndThenAnother) {
  for (const char* acceptance : {"(Fin(0) & Inf(1)) | (Inf(0) & Fin(2))", "(Fin(2) & Inf(1)) | (Inf(2) & Fin(0))",
                                 "(Inf(0) & Fin(2)) | (Fin(0) & Inf(1))", "(Inf(2) & Fin(0)) | (Fin(2) & Inf(1))"}) {
    const Automaton a = read_omega_hoa(std::string("HOA: v1 Start: 0 AP: 1 \"a\" Acceptance: 3 ") + acceptance +
                                       " --BODY-- State: 0 [0] 0 {0} [!0] 0 {2} --END--");
    const std::optional<ltl::Lasso> word = find_lasso(a);
    ASSERT_TRUE(word) << acceptance;
    EXPECT_TRUE(referee::accepts(a, *word)) << acceptance;
  }
}

AlternatingBuchi random_alternating(ltl::Random& random, std::uint32_t states) {
  AlternatingBuchi out;
  Boolean logic(out.diagram);
  const auto some_states = [&] {
    std::set<std::uint32_t> some;
    for (std::size_t n = 1 + random.below(2); n > 0; --n) some.insert(static_cast<std::uint32_t>(random.below(states)));
    return std::vector<std::uint32_t>(some.begin(), some.end());
  };
  out.edges.resize(states);
  for (auto& edges : out.edges)
    for (std::size_t n = 1 + random.below(3); n > 0; --n) {
      Mtbdd::Node label = Boolean::constant(true);
      for (Mtbdd::Variable v = 0; v < 2; ++v) {
        const Mtbdd::Node literal = logic.variable(v);
        const std::size_t kind = random.below(3);
        if (kind < 2) label = logic.conjunction(label, kind == 0 ? literal : logic.negate(literal));
      }
      edges.push_back({label, some_states(), random.chance(0.4)});
    }
  for (std::size_t n = random.below(3); n > 0 || out.starts.empty(); n -= n > 0 ? 1 : 0)
    out.starts.push_back(some_states());
  return out;
}

TEST(Alternation, IsRemovedWithoutChangingTheLanguage) {
  ltl::Random random(15);
  std::size_t accepted = 0;
  for (int i = 0; i < 150; ++i) {
    const AlternatingBuchi alternating = random_alternating(random, static_cast<std::uint32_t>(1 + i % 4));
    Budget budget;
    const Automaton plain = as_automaton(without_alternation(alternating, budget), ab, {{0}, {1}});
    testing::for_each_lasso(small, [&](const ltl::Lasso& word) {
      const bool expected = referee::accepts(alternating, word);
      accepted += expected ? 1 : 0;
      ASSERT_EQ(referee::accepts(plain, word), expected) << i << '\n' << show(plain, word);
    });
  }
  EXPECT_GT(accepted, 0U);
}

}  // namespace
}  // namespace waymark::automata
