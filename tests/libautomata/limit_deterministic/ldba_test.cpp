// Limit-deterministic automata: their shape, their language by the definition, and what makes them usable: in random
// Markov decision processes they win with the same probability as the deterministic automaton.
#include <gtest/gtest.h>

#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/limit_deterministic/jump_on_colour.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/limit_deterministic/master_theorem.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libautomata/limit_deterministic/mdp_referee.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Lasso;
using testing::show;

// Deterministic but for the jumps, which lead into the accepting part; marks in it only; nothing leaves it.
::testing::AssertionResult well_formed(const MdpSafe& ldba) {
  const Automaton& all = ldba.automaton();
  for (std::uint32_t q = 0; q < ldba.states(); ++q) {
    const bool inside = ldba.in_accepting_part(StateId{q});
    if (inside && !ldba.jumps(StateId{q}).empty())
      return ::testing::AssertionFailure() << "a jump from the accepting part, state " << q;
    for (StateId target : ldba.jumps(StateId{q}))
      if (!ldba.in_accepting_part(target))
        return ::testing::AssertionFailure() << "a jump that does not lead into the accepting part";
    for (std::uint32_t c : choices_of(all.transitions(), q)) {
      const auto choice = all.transitions().choices[c];
      if (choice.size() > 1 + ldba.jumps(StateId{q}).size())
        return ::testing::AssertionFailure() << "more branches than jumps in state " << q;
      for (const Branch& b : choice)
        if (inside && !ldba.in_accepting_part(StateId{b.target}))
          return ::testing::AssertionFailure() << "state " << q << " leaves the accepting part";
    }
  }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult agree(Formula f, const Automaton& automaton, const Lasso& word) {
  if (accepts(automaton, word) == ltl::holds(word, f)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << show(f, word) << " holds: " << ltl::holds(word, f);
}

// One construction alone, assembled with or without comparing languages, over the propositions of the formula.
struct Way {
  bool by_theorem, compare;
};
LimitDeterministic bare(Formula simple, const std::vector<ltl::Proposition>& reads, Way way) {
  Budget budget;
  const Automaton dpa = ltl_to_dpa(simple).automaton();
  const TransitionRelation parity = completed_parity(min_even_parity(renamed(dpa.transitions(), dpa.reads(), reads)));
  AcceptingPart accepting_part;
  const auto jumps = way.by_theorem ? jump_by_master_theorem(simple, parity, reads, accepting_part, budget)
                                    : std::optional(jump_on_colour(parity, accepting_part));
  return assembled(parity, accepting_part, {jumps.value()}, way.compare, budget).front();
}

class Guessing : public ::testing::TestWithParam<Way> {};

TEST_P(Guessing, AgreesWithTheDefinitionOnAllSmallPairs) {
  ltl::Arena arena;
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const Formula simple = ltl::simplify(f, ltl::Over::Infinite);
    const auto reads = ltl::propositions(simple);
    Budget budget;
    const Automaton made(arena.vocabulary(), reads, without_jumps(bare(simple, reads, GetParam()), budget));
    for (const Lasso& word : words) ASSERT_TRUE(agree(f, made, word));
  });
}

TEST_P(Guessing, WinsInMarkovDecisionProcessesWithTheProbabilityOfTheFormula) {
  constexpr std::uint64_t seed = 10;
  ltl::Random random(seed);
  for (int i = 0; i < testing::scaled(200); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const Formula f = ltl::simplify(ltl::random_formula(random, arena, {.size = 4 + random.below(12), .atoms = 2}),
                                    ltl::Over::Infinite);
    const auto reads = ltl::propositions(f);
    const LimitDeterministic ldba = bare(f, reads, GetParam());
    const Dpa dpa = ltl_to_dpa(f);
    for (int j = 0; j < 5; ++j) {
      const referee::World world = referee::random_world(random, 2 + static_cast<std::uint32_t>(random.below(4)),
                                                         {ltl::Proposition{0}, ltl::Proposition{1}});
      ASSERT_NEAR(referee::greatest_probability(world, ldba, reads), referee::greatest_probability(world, dpa), 1e-6)
          << show(f) << "; seed " << seed << ", formula " << i << ", MDP " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, Guessing,
                         ::testing::Values(Way{false, false}, Way{false, true}, Way{true, false}, Way{true, true}));

TEST(LtlToLdba, AgreesWithTheDefinitionOnRandomPairs) {
  constexpr std::uint64_t seed = 7;
  ltl::Random random(seed);
  for (int i = 0; i < testing::scaled(300); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 6 + random.below(14), .atoms = 3});
    const MdpSafe ldba = ltl_to_ldba(f);
    ASSERT_TRUE(well_formed(ldba)) << show(f);
    for (int j = 0; j < 60; ++j) {
      const Lasso word =
          ltl::random_lasso(random, {.prefix = random.below(5), .cycle = 1 + random.below(5), .atoms = 3});
      ASSERT_TRUE(agree(f, ldba.automaton(), word)) << "seed " << seed << ", formula " << i;
    }
  }
}

// The language is decided, not tried: against the generalised Büchi automata of φ and ¬φ.
TEST(LtlToLdba, HasTheLanguageOfTheTableau) {
  constexpr std::uint64_t seed = 8;
  ltl::Random random(seed);
  for (int i = 0; i < testing::scaled(150); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 8 + random.below(14), .atoms = 3});
    const Automaton ldba = ltl_to_ldba(f).automaton();
    const Automaton yes = ltl_to_tgba(f), no = ltl_to_tgba(ltl::negate(f));
    Budget budget;
    ASSERT_TRUE(is_empty(intersection(ldba, no, budget).transitions())) << show(f) << " accepts too much";
    const TransitionRelation outside = complement_parity(determinize(ldba.transitions(), budget));
    const Automaton rejected(ldba.vocabulary(), ldba.reads(), outside);
    ASSERT_TRUE(is_empty(intersection(yes, rejected, budget).transitions())) << show(f) << " accepts too little";
  }
}

TEST(LtlToLdba, WinsInMarkovDecisionProcessesWithTheProbabilityOfTheFormula) {
  constexpr std::uint64_t seed = 9;
  ltl::Random random(seed);
  int proper = 0;  // neither 0 nor 1
  for (int i = 0; i < testing::scaled(400); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const Formula f = ltl::random_formula(random, arena, {.size = 4 + random.below(12), .atoms = 2});
    const MdpSafe ldba = ltl_to_ldba(f);
    const Dpa dpa = ltl_to_dpa(f);
    for (int j = 0; j < 5; ++j) {
      const referee::World world = referee::random_world(random, 2 + static_cast<std::uint32_t>(random.below(4)),
                                                         {ltl::Proposition{0}, ltl::Proposition{1}});
      const double expected = referee::greatest_probability(world, dpa);
      const double found = referee::greatest_probability(world, ldba);
      ASSERT_NEAR(found, expected, 1e-6) << show(f) << "; seed " << seed << ", formula " << i << ", MDP " << j;
      proper += expected > 1e-6 && expected < 1 - 1e-6 ? 1 : 0;
    }
  }
  EXPECT_GT(proper, testing::scaled(50));  // else nothing was tried
}

// What the type is for: X a | X !a by a jump at the first letter accepts every word and wins half of the time.
TEST(LtlToLdba, TheRefereeSeesAGuessThatComesTooEarly) {
  ltl::Letter heads;
  heads.insert(ltl::Proposition{0});
  const referee::World coin{{{}, heads}, {{{{0.5, 0}, {0.5, 1}}}, {{{0.5, 0}, {0.5, 1}}}}};
  using referee::Next;
  const auto step = [&](std::uint32_t q, const ltl::Letter& letter) -> Next {
    const bool is_heads = letter.contains(ltl::Proposition{0});
    switch (q) {
      case 1: return Next({3, 1});  // any letter, then heads
      case 2: return Next({4, 1});  // any letter, then tails
      case 3: return is_heads ? Next({5, 1}) : Next();
      case 4: return is_heads ? Next() : Next({5, 1});
      case 5: return Next({5, 0});
      default: return {};
    }
  };
  const auto jumps = [](std::uint32_t q) {
    return q == 0 ? std::vector<std::uint32_t>{1, 2} : std::vector<std::uint32_t>();
  };
  EXPECT_NEAR(referee::greatest_probability(coin, 0, 1, step, jumps), 0.5, 1e-6);
  ltl::Arena arena(testing::letters_vocabulary(1));
  const MdpSafe ours = ltl_to_ldba(ltl::parse("X a | X !a", arena));
  EXPECT_NEAR(referee::greatest_probability(coin, ours), 1, 1e-6);
}

TEST(LtlToLdba, HasTheSizesThatTheTheoryKnows) {
  const struct {
    const char* formula;
    std::size_t states, jumps;
  } table[] = {
      {"false", 1, 0},         {"true", 1, 0},
      {"G F a", 1, 0},         {"F a", 2, 0},
      {"F G a", 2, 1},         {"F G a | G F b", 3, 2},
      {"G F a & F G b", 2, 1}, {"G(a -> F b)", 2, 0},
      {"F G a | F G b", 3, 2}, {"(F G a | G F b) & (F G c | G F d)", 6, 4},
  };
  for (const auto& row : table) {
    ltl::Arena arena;
    const MdpSafe ldba = ltl_to_ldba(ltl::parse(row.formula, arena));
    std::size_t jumps = 0;
    for (std::uint32_t q = 0; q < ldba.states(); ++q) jumps += ldba.jumps(StateId{q}).size();
    EXPECT_EQ(ldba.states(), row.states) << row.formula;
    EXPECT_EQ(jumps, row.jumps) << row.formula;
    EXPECT_EQ(ldba.is_deterministic(), row.jumps == 0) << row.formula;
  }
}

TEST(LtlToLdba, GivesUpWithinItsLimits) {
  ltl::Arena arena;
  const Formula f = ltl::parse("(G F(a & X b) | F G c) & (G F(c & X a) | F G b)", arena);
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_ldba(f, {.states = 2})));
  std::stop_source source;
  source.request_stop();
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_ldba(f, {.stop = source.get_token()})));
  const Formula g = ltl::parse("F G(a | X b) | G F(c & X d)", arena);  // one copy for each colour that is guessed
  EXPECT_TRUE(std::holds_alternative<Translated>(ltl_to_parity(g, {.states = 7})));
  EXPECT_TRUE(std::holds_alternative<Exhausted>(ltl_to_ldba(g, {.states = 7})));
}

}  // namespace
}  // namespace waymark::automata
