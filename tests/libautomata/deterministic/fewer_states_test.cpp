// Merging states of one language: random parity automata keep their language, by emptiness of the differences and on
// lassos; the sizes where the number of languages says what there must be; and the merges of the definition.
#include "libautomata/deterministic/fewer_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/inclusion.hpp"
#include "libautomata/deterministic/one_language.hpp"
#include "libautomata/deterministic/parity.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/greedy_merging.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

const ltl::Vocabulary ab({"a", "b"});

// One mark at most on a branch, of parity(Min, Even, sets).
TransitionRelation random_parity(ltl::Random& random, const RandomAutomaton& options) {
  TransitionRelation out = random_automaton(random, ab, options).transitions();
  std::vector<std::uint32_t> all;
  for (std::uint32_t q = 0; q < out.states(); ++q) all.push_back(q);
  out = rebuild(out, all, [](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches)
      if (!b.marks.empty()) b.marks = Marks::of(b.marks.members().front());
    return branches;
  });
  out.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, out.acceptance.sets);
  return out;
}

bool within(const TransitionRelation& a, const TransitionRelation& b) {
  const std::vector<ltl::Proposition> reads{{0}, {1}};
  const Automaton of_a = as_automaton(a, ab, reads), of_b = as_automaton(b, ab, reads);
  Budget budget;
  const Automaton outside = complement(*Deterministic::checked(of_b)).automaton();
  return is_empty(intersection(of_a, outside, budget).transitions());
}

TEST(FewerStates, KeepTheLanguageOfRandomAutomata) {
  constexpr std::uint64_t seed = 91;
  ltl::Random random(seed);
  int smaller = 0;
  for (int i = 0; i < 600; ++i) {
    const TransitionRelation from = random_parity(random, {.states = static_cast<std::uint32_t>(2 + i % 7),
                                                           .sets = static_cast<std::uint32_t>(1 + i % 4),
                                                           .branches = 1,
                                                           .marked = i % 3 == 0 ? 0.5 : 0.2,
                                                           .empty = i % 4 == 0 ? 0.1 : 0.0,
                                                           .generic = false});
    Budget budget;
    const TransitionRelation made = trim(with_fewer_states(from, budget).automaton);
    ASSERT_TRUE(within(made, from)) << "seed " << seed << ", automaton " << i;
    ASSERT_TRUE(within(from, made)) << "seed " << seed << ", automaton " << i;
    ASSERT_LE(made.states(), from.states());
    ASSERT_LE(count_languages(trim(from), budget), made.states()) << "seed " << seed << ", automaton " << i;
    if (made.states() < trim(from).states()) ++smaller;
  }
  EXPECT_GT(smaller, 100);
}

// Whatever few words and pairs say, against inclusion both ways.
TEST(Languages, AreThoseThatIncludeEachOther) {
  constexpr std::uint64_t seed = 93;
  ltl::Random random(seed);
  int shared = 0, apart = 0;
  for (int i = 0; i < testing::scaled(600); ++i) {
    const TransitionRelation from = random_parity(random, {.states = static_cast<std::uint32_t>(2 + i % 9),
                                                           .sets = static_cast<std::uint32_t>(1 + i % 4),
                                                           .branches = 1,
                                                           .marked = i % 3 == 0 ? 0.5 : 0.05,
                                                           .empty = i % 4 == 0 ? 0.1 : 0.0,
                                                           .generic = false});
    const TransitionRelation complete = completed_parity(from);
    Budget budget;
    const std::vector<std::uint32_t> language = languages(complete, budget);
    const std::vector<std::vector<bool>> included = inclusions(complete, complete, budget);
    for (std::uint32_t q = 0; q < complete.states(); ++q)
      for (std::uint32_t r = 0; r < q; ++r) {
        const bool same = included[q][r] && included[r][q];
        ASSERT_EQ(language[q] == language[r], same) << "seed " << seed << ", automaton " << i << ", " << q << ' ' << r;
        ++(same ? shared : apart);
      }
  }
  EXPECT_GT(shared, apart / 20);
  EXPECT_GT(apart, shared / 20);
}

// Reducing what was reduced changes nothing; states are counted against the words of the original.
TEST(FewerStates, AreFoundOnceAndForAll) {
  ltl::Random random(92);
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  for (int i = 0; i < 60; ++i) {
    const TransitionRelation from =
        random_parity(random, {.states = 6, .sets = 3, .branches = 1, .empty = 0, .generic = false});
    Budget budget;
    const TransitionRelation once = reduce_parity(from, budget).automaton;
    const TransitionRelation twice = reduce_parity(once, budget).automaton;
    ASSERT_EQ(once.states(), twice.states()) << i;
    const Automaton before = as_automaton(from, ab, {{0}, {1}}), after = as_automaton(once, ab, {{0}, {1}});
    for (const ltl::Lasso& word : words)
      ASSERT_EQ(referee::accepts(after, word), referee::accepts(before, word))
          << i << '\n'
          << write_hoa(before) << "on " << ltl::show(word, ab);
  }
}

// Complete, over a and b.
test::LetterwiseParity letterwise(const TransitionRelation& complete, const std::vector<std::uint32_t>& language) {
  test::LetterwiseParity out{{}, complete.initial, complete.acceptance.sets + 1, language};
  for (const Mtbdd::Node root : complete.roots) {
    out.steps.emplace_back();
    for (unsigned letter = 0; letter < 4; ++letter) {
      const auto at = complete.diagram.evaluate(root, [&](Mtbdd::Variable v) { return (letter >> v & 1U) != 0; });
      const Branch& branch = complete.choices[Mtbdd::payload(at)].front();
      out.steps.back().push_back({branch.target, colour_of(complete, branch.marks)});
    }
  }
  return out;
}

// States that the initial one reaches.
std::size_t reachable(const TransitionRelation& automaton) {
  std::vector<std::uint32_t> found{automaton.initial};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Branch& b : branches_of(automaton, found[i]))
      if (std::find(found.begin(), found.end(), b.target) == found.end()) found.push_back(b.target);
  return found.size();
}

void expect_as_defined(const TransitionRelation& from, const std::string& what) {
  const TransitionRelation complete = completed_parity(trim(from));
  Budget budget;
  const std::vector<std::uint32_t> language = languages(complete, budget);
  const TransitionRelation made = with_fewer_states(complete, language, budget).automaton;
  ASSERT_EQ(reachable(made), test::merged_states(letterwise(complete, language))) << what;
}

// Twice the states: a bit that changes on letters with a, and that nothing reads.
TransitionRelation doubled(const TransitionRelation& complete) {
  TransitionRelation out;
  out.acceptance = complete.acceptance;
  out.initial = complete.initial;
  const auto states = static_cast<std::uint32_t>(complete.states());
  for (std::uint32_t q = 0; q < 2 * states; ++q) {
    const auto on = [&](unsigned letter) {
      const auto at = complete.diagram.evaluate(complete.roots[q % states],
                                                [&](Mtbdd::Variable v) { return (letter >> v & 1U) != 0; });
      const Branch& b = complete.choices[Mtbdd::payload(at)].front();
      const std::uint32_t bit = (q / states + letter) % 2;
      return Mtbdd::terminal(out.choices.intern({{b.target + bit * states, b.marks}}));
    };
    const Mtbdd::Node none = on(0), a = on(1), b = on(2), both = on(3);
    const Mtbdd::Node low = out.diagram.make(1, none, b), high = out.diagram.make(1, a, both);
    out.roots.push_back(out.diagram.make(0, low, high));
  }
  return out;
}

// Whichever pairs, letters and branches of the product are looked at first: the merges are those of the definition.
TEST(FewerStates, AreThoseOfTheDefinition) {
  constexpr std::uint64_t seed = 94;
  ltl::Random random(seed);
  for (int i = 0; i < testing::scaled(200); ++i) {
    const TransitionRelation from = random_parity(random, {.states = static_cast<std::uint32_t>(2 + i % 7),
                                                           .sets = static_cast<std::uint32_t>(1 + i % 4),
                                                           .branches = 1,
                                                           .marked = i % 3 == 0 ? 0.5 : 0.2,
                                                           .empty = 0,
                                                           .generic = false});
    expect_as_defined(from, "seed " + std::to_string(seed) + ", automaton " + std::to_string(i));
  }
}

// One language each, and more pairs that cannot be merged than it takes to choose few letters.
TEST(FewerStates, AreThoseOfTheDefinitionWhereFewLettersRefute) {
  for (const std::string text :
       {"F G(a | b) | F G(!a | X b) | F G(a | X X b)", "G F(a & X b) & G F(!a & X X b) & G F(b & X !a)",
        "G F(a & X X b) -> G F(b & X a)", "(G F a -> G F b) & (G F X(a & X b) -> G F !a)"}) {
    ltl::Arena arena(ab);
    const TransitionRelation from = min_even_parity(ltl_to_dpa(ltl::parse(text, arena)).automaton().transitions());
    expect_as_defined(from, text);
    expect_as_defined(doubled(completed_parity(from)), text + ", doubled");
  }
}

// GF a, spread over three states that count how often a was read: one language, one state.
TEST(FewerStates, OneLanguageThatColoursCanTell) {
  TransitionRelation from;
  from.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, 2);
  for (std::uint32_t q = 0; q < 3; ++q) {
    const Mtbdd::Node stay = Mtbdd::terminal(from.choices.intern({{q, Marks::of(1)}}));
    const Marks marks = q == 2 ? Marks::of(0) : Marks::of(1);
    const Mtbdd::Node go = Mtbdd::terminal(from.choices.intern({{(q + 1) % 3, marks}}));
    from.roots.push_back(from.diagram.make(0, stay, go));
  }
  Budget budget;
  EXPECT_EQ(trim(with_fewer_states(from, budget).automaton).states(), 1U);
}

// GF a ∧ GF b by turns: one language again, but one state with one colour a branch cannot tell.
TEST(FewerStates, OneLanguageThatColoursCannotTell) {
  TransitionRelation from;
  from.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, 2);
  for (std::uint32_t q = 0; q < 2; ++q) {
    const Mtbdd::Node stay = Mtbdd::terminal(from.choices.intern({{q, Marks::of(1)}}));
    const Mtbdd::Node go = Mtbdd::terminal(from.choices.intern({{1 - q, Marks::of(q == 1 ? 0 : 1)}}));
    from.roots.push_back(from.diagram.make(q, stay, go));
  }
  Budget budget;
  EXPECT_EQ(trim(with_fewer_states(from, budget).automaton).states(), 2U);
}

// Whatever the budget, the language stays; too little of it is said.
TEST(FewerStates, AreValidWhereverTheEffortEnds) {
  ltl::Random random(93);
  for (int i = 0; i < 30; ++i) {
    const TransitionRelation from =
        random_parity(random, {.states = 7, .sets = 3, .branches = 1, .empty = 0, .generic = false});
    for (std::size_t steps = 0; steps < 4'000; steps = steps * 2 + 1) {
      Budget budget(steps, SIZE_MAX, {});
      const Reduced made = reduce_parity(from, budget);
      ASSERT_TRUE(within(made.automaton, from)) << i << ", steps " << steps;
      ASSERT_TRUE(within(from, made.automaton)) << i << ", steps " << steps;
    }
  }
  const TransitionRelation from =
      random_parity(random, {.states = 7, .sets = 3, .branches = 1, .empty = 0, .generic = false});
  Budget none(0, SIZE_MAX, {}), all;
  EXPECT_FALSE(reduce_parity(from, none).complete);
  EXPECT_TRUE(reduce_parity(from, all).complete);
}

}  // namespace
}  // namespace waymark::automata
