// Both comparisons find the relation of the definition, computed letter by letter from the greatest relation downwards.
#include "libautomata/omega/greatest_simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "libautomata/omega/alphabet_classes.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

constexpr std::size_t atoms = 3, letters = 1U << atoms;
constexpr std::uint64_t seed = 61;

struct Step {
  std::uint32_t from, letter, to;
  Marks marks;
};

std::vector<Step> steps(const TransitionRelation& automaton) {
  std::vector<Step> out;
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t letter = 0; letter < letters; ++letter) {
      const auto holds = [&](Mtbdd::Variable v) { return (letter >> v & 1U) != 0; };
      const Mtbdd::Node n = automaton.diagram.evaluate(automaton.roots[q], holds);
      for (const Branch& b : automaton.choices[Mtbdd::payload(n)]) out.push_back({q, letter, b.target, b.marks});
    }
  return out;
}

StatePairs by_definition(std::vector<Step> all, std::size_t states, std::optional<std::uint32_t> initial) {
  if (initial)
    for (Step& s : all) std::swap(s.from, s.to);
  std::vector<std::vector<Step>> from(states);
  for (const Step& s : all) from[s.from].push_back(s);
  StatePairs below(states, true);
  for (std::uint32_t r = 0; r < states; ++r)
    if (initial && r != *initial) below.remove(*initial, r);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Step& s : all)
      for (std::uint32_t r = 0; r < states; ++r) {
        const bool matched = std::any_of(from[r].begin(), from[r].end(), [&](const Step& t) {
          return t.letter == s.letter && t.marks.includes(s.marks) && below(s.to, t.to);
        });
        if (matched || !below(s.from, r)) continue;
        below.remove(s.from, r);
        changed = true;
      }
  }
  return below;
}

TEST(GreatestSimulation, IsTheRelationOfTheDefinitionForwardsAndBackwards) {
  ltl::Random random(seed);
  const auto vocabulary = testing::letters_vocabulary(atoms);
  Budget budget;
  std::size_t related = 0, pairs = 0;
  for (std::size_t i = 0; i < (testing::sanitized ? 40U : 200U); ++i) {
    const Automaton automaton = random_automaton(random, vocabulary,
                                                 {.states = static_cast<std::uint32_t>(2 + random.below(5)),
                                                  .atoms = 1 + random.below(atoms),
                                                  .sets = static_cast<std::uint32_t>(random.below(3)),
                                                  .empty = 0.4,
                                                  .generic = false});
    TransitionRelation a = automaton.transitions();
    a.initial = static_cast<std::uint32_t>(i % a.states());
    const StatePairs after = by_definition(steps(a), a.states(), {});
    const StatePairs before = by_definition(steps(a), a.states(), a.initial);
    for (const Comparison how : {Comparison::Cheapest, Comparison::OfDiagrams}) {
      EXPECT_EQ(greatest_simulation(a, budget, how), after) << "seed " << seed << ", automaton " << i;
      EXPECT_EQ(greatest_reverse_simulation(a, budget, how), before) << "seed " << seed << ", automaton " << i;
    }
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (std::uint32_t r = 0; r < a.states(); ++r, ++pairs) related += q != r && after(q, r) ? 1U : 0U;
  }
  EXPECT_GT(related, pairs / 50);
  EXPECT_LT(related, pairs / 2);
}

// Many states, most of which single letters tell apart: every state of a small automaton several times, each copy with
// targets among the copies.
TEST(GreatestSimulation, IsTheRelationOfTheDefinitionOnManyStates) {
  ltl::Random random(seed);
  Budget budget;
  for (std::size_t i = 0; i < (testing::sanitized ? 1U : 6U); ++i) {
    const Automaton small = random_automaton(random, testing::letters_vocabulary(2),
                                             {.states = 9, .atoms = 2, .sets = 1, .empty = 0.4, .generic = false});
    const auto states = static_cast<std::uint32_t>(small.states());
    const std::uint32_t copies = 45 / states + 1;
    TransitionRelation many;
    many.acceptance = small.transitions().acceptance;
    for (std::uint32_t copy = 0; copy < copies; ++copy)
      for (const Mtbdd::Node root : small.transitions().roots) {
        const auto spread = [&](std::uint32_t choice) {
          std::vector<Branch> branches;
          for (const Branch& b : small.transitions().choices[choice])
            branches.push_back({b.target + states * static_cast<std::uint32_t>(random.below(copies)), b.marks});
          return Mtbdd::terminal(many.choices.intern(branches));
        };
        const auto keep = [](Mtbdd::Variable v) { return v; };
        many.roots.push_back(many.diagram.import(small.transitions().diagram, std::vector{root}, spread, keep).front());
      }
    const StatePairs after = by_definition(steps(many), many.states(), {});
    EXPECT_EQ(greatest_simulation(many, budget, Comparison::OfDiagrams), after) << "seed " << seed << ", " << i;
    EXPECT_EQ(greatest_simulation(many, budget, Comparison::Cheapest), after) << "seed " << seed << ", " << i;
  }
}

// More choices than pairs of which are remembered: q ≤ r exactly where the marks of q are among those of r.
TEST(GreatestSimulation, OfManyChoicesIsThatOfTheirMarks) {
  constexpr std::uint32_t states = 600;
  TransitionRelation many;
  for (std::uint32_t q = 0; q < states; ++q)
    many.roots.push_back(Mtbdd::terminal(many.choices.intern({{0, Marks::from_bits(q)}})));
  Budget budget;
  for (const Comparison how : {Comparison::Cheapest, Comparison::OfDiagrams}) {
    const StatePairs below = greatest_simulation(many, budget, how);
    for (std::uint32_t q = 0; q < states; ++q)
      for (std::uint32_t r = 0; r < states; ++r) ASSERT_EQ(below(q, r), (q & r) == q) << q << ' ' << r;
  }
}

TEST(AlphabetClasses, AreAsManyAsThereAreDifferentColumns) {
  ltl::Random random(seed);
  const auto vocabulary = testing::letters_vocabulary(atoms);
  Budget budget;
  for (std::size_t i = 0; i < 50; ++i) {
    const Automaton automaton = random_automaton(random, vocabulary, {.states = 3, .atoms = atoms, .empty = 0.6});
    const TransitionRelation& a = automaton.transitions();
    const auto table = alphabet_classes(a, letters, budget);
    ASSERT_TRUE(table.has_value());
    std::set<std::vector<std::uint32_t>> columns;
    for (std::uint32_t letter = 0; letter < letters; ++letter) {
      std::vector<std::uint32_t> column;
      for (Mtbdd::Node root : a.roots)
        column.push_back(
            Mtbdd::payload(a.diagram.evaluate(root, [&](Mtbdd::Variable v) { return (letter >> v & 1U) != 0; })));
      columns.insert(column);
    }
    std::set<std::vector<std::uint32_t>> kinds;
    for (std::size_t kind = 0; kind < table->kinds; ++kind) {
      std::vector<std::uint32_t> column;
      for (std::size_t q = 0; q < a.states(); ++q) column.push_back(table->row(q)[kind]);
      kinds.insert(column);
    }
    EXPECT_EQ(kinds, columns) << "seed " << seed << ", automaton " << i;
    EXPECT_EQ(table->kinds, columns.size());
  }
}

TEST(AlphabetClasses, AreNotListedWhereTheyAreMany) {
  Budget budget;
  TransitionRelation parity;  // two choices on three propositions: eight paths, two kinds
  const std::uint32_t stay = parity.choices.intern({{0, Marks::of(0)}});
  const Mtbdd::Node no = Mtbdd::terminal(Choices::none), yes = Mtbdd::terminal(stay);
  Mtbdd& d = parity.diagram;
  const Mtbdd::Node odd = d.make(2, no, yes), even = d.make(2, yes, no);
  parity.roots = {d.make(0, d.make(1, odd, even), d.make(1, even, odd))};
  EXPECT_FALSE(alphabet_classes(parity, 7, budget).has_value());
  const auto table = alphabet_classes(parity, 8, budget);
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->kinds, 2U);
}

}  // namespace
}  // namespace waymark::automata
