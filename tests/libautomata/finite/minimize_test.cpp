// Both minimisers against a slow and obvious one, on random automata of either kind.
#include "libautomata/finite/minimize.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/refinement.hpp"
#include "libautomata/finite/very_weak.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::automata {
namespace {

constexpr std::uint32_t letters = 4;  // of two propositions

// next[q][letter]; in a very weak automaton edges go to q itself or to smaller states.
struct Table {
  std::vector<std::array<std::uint32_t, letters>> next;
  std::vector<bool> accepting;
};

Table random_table(ltl::Random& random, std::uint32_t states, bool very_weak) {
  Table out;
  for (std::uint32_t q = 0; q < states; ++q) {
    out.next.emplace_back();
    for (std::uint32_t& r : out.next.back()) r = static_cast<std::uint32_t>(random.below(very_weak ? q + 1 : states));
    out.accepting.push_back(random.chance(0.3));
  }
  out.accepting.back() = false;  // the initial state
  return out;
}

Transitions symbolic(const Table& table) {
  Transitions out;
  for (const auto& next : table.next) {
    const auto leaf = [&](std::uint32_t letter) { return Mtbdd::terminal(next[letter]); };
    const Mtbdd::Node low = out.diagram.make(1, leaf(0), leaf(2)), high = out.diagram.make(1, leaf(1), leaf(3));
    out.roots.push_back(out.diagram.make(0, low, high));
  }
  out.accepting = table.accepting;
  out.initial = static_cast<std::uint32_t>(table.next.size()) - 1;
  return out;
}

// Moore: split by the classes of the successors until nothing splits.
std::vector<std::size_t> moore(const Table& table) {
  std::vector<std::size_t> of(table.accepting.begin(), table.accepting.end());
  for (std::size_t classes = 0;;) {
    std::map<std::vector<std::size_t>, std::size_t> names;
    std::vector<std::size_t> finer;
    for (std::size_t q = 0; q < of.size(); ++q) {
      std::vector<std::size_t> signature{of[q]};
      for (std::uint32_t r : table.next[q]) signature.push_back(of[r]);
      finer.push_back(names.try_emplace(signature, names.size()).first->second);
    }
    of = finer;
    if (names.size() == classes) return of;
    classes = names.size();
  }
}

::testing::AssertionResult same_partition(const Table& table, const Partition& partition) {
  const std::vector<std::size_t> expected = moore(table);
  for (std::size_t p = 0; p < expected.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if ((expected[p] == expected[q]) != (partition.class_of[p] == partition.class_of[q]))
        return ::testing::AssertionFailure() << "states " << q << " and " << p;
  if (partition.classes != std::set(expected.begin(), expected.end()).size())
    return ::testing::AssertionFailure() << partition.classes << " classes";
  return ::testing::AssertionSuccess();
}

TEST(Minimize, RefinementFindsTheCoarsestPartition) {
  ltl::Random random(11);
  for (int i = 0; i < 3000; ++i) {
    const Table table = random_table(random, 1 + static_cast<std::uint32_t>(random.below(12)), random.chance(0.3));
    const Transitions automaton = symbolic(table);
    const TransitionGraph graph(automaton.diagram, automaton.roots);
    Budget unlimited;
    ASSERT_TRUE(same_partition(table, coarsest_partition(automaton, graph, unlimited))) << "automaton " << i;
  }
}

// A ring with some edges across it: classes split a few states at a time, in many rounds, so that former images are
// dropped on the way.
Table ring(ltl::Random& random, std::uint32_t states) {
  Table out;
  const std::size_t period = 1 + random.below(states / 4);
  for (std::uint32_t q = 0; q < states; ++q) {
    out.next.emplace_back();
    for (std::uint32_t letter = 0; letter < letters; ++letter) out.next.back()[letter] = (q + 1 + letter / 2) % states;
    if (random.chance(0.01)) out.next.back()[1] = static_cast<std::uint32_t>(random.below(states));
    out.accepting.push_back(q % period == 0);
  }
  out.accepting.back() = false;
  return out;
}

TEST(Minimize, RefinementTakesManyRoundsAndMuchAtATime) {
  ltl::Random random(15);
  for (int i = 0; i < 12; ++i) {
    const auto states = static_cast<std::uint32_t>(200 + random.below(200));
    const Table table = i % 3 == 0 ? random_table(random, 5 * states, false) : ring(random, states);
    const Transitions automaton = symbolic(table);
    const TransitionGraph graph(automaton.diagram, automaton.roots);
    Budget unlimited;
    const Partition partition = coarsest_partition(automaton, graph, unlimited);
    ASSERT_TRUE(same_partition(table, partition)) << "automaton " << i;
    for (std::uint32_t q = 0; q < states; ++q) {  // and says where each class leads
      for (std::uint32_t letter = 0; letter < letters; ++letter) {
        const auto holds = [&](Mtbdd::Variable v) { return ((letter >> v) & 1U) != 0; };
        const Mtbdd::Node to = partition.diagram.evaluate(partition.roots[partition.class_of[q]], holds);
        ASSERT_EQ(Mtbdd::payload(to), partition.class_of[table.next[q][letter]]) << "automaton " << i;
      }
    }
  }
}

TEST(Minimize, OnePassFindsTheCoarsestPartitionOfVeryWeakAutomata) {
  ltl::Random random(12);
  for (int i = 0; i < 5000; ++i) {
    const Table table = random_table(random, 1 + static_cast<std::uint32_t>(random.below(10)), true);
    const Transitions automaton = symbolic(table);
    const TransitionGraph graph(automaton.diagram, automaton.roots);
    const auto partition = very_weak_partition(automaton, graph);
    ASSERT_TRUE(partition.has_value());
    ASSERT_TRUE(same_partition(table, *partition)) << "automaton " << i;
  }
}

TEST(Minimize, OnePassDeclinesCycles) {
  const Table table{{{1, 1, 1, 1}, {0, 0, 0, 0}}, {true, false}};
  const Transitions automaton = symbolic(table);
  const TransitionGraph graph(automaton.diagram, automaton.roots);
  EXPECT_FALSE(very_weak_partition(automaton, graph).has_value());
}

TEST(Minimize, KeepsTheLanguageAndCannotBeRepeated) {
  ltl::Random random(13);
  for (int i = 0; i < 300; ++i) {
    const Transitions automaton = canonical(symbolic(random_table(random, 8, random.chance(0.5))));
    const Dfa before = as_dfa(automaton, ltl::Vocabulary({"a", "b"}), {{0}, {1}});
    const Dfa once = minimize(before), twice = minimize(once);
    ASSERT_FALSE(difference(before, once).has_value()) << "automaton " << i;
    ASSERT_EQ(once.states(), twice.states());
    for (std::uint32_t q = 0; q < once.states(); ++q) ASSERT_EQ(once.root(StateId{q}), twice.root(StateId{q}));
  }
}

// The initial state is the last one or any other: what is made has as many states as there are classes, and the words.
TEST(Minimize, BeginsAnywhere) {
  ltl::Random random(17);
  for (int i = 0; i < 400; ++i) {
    const auto states = 1 + static_cast<std::uint32_t>(random.below(8));
    const Table drawn = random_table(random, states, random.chance(0.3));
    for (std::uint32_t first = 0; first < states; ++first) {
      Table table = drawn;
      table.accepting[first] = false;
      Transitions automaton = symbolic(table);
      automaton.initial = first;
      Budget unlimited;
      const Transitions made = minimize(automaton, unlimited);
      const std::vector<std::size_t> classes = moore(table);
      ASSERT_EQ(made.roots.size(), std::set(classes.begin(), classes.end()).size()) << "automaton " << i;
      const ltl::Vocabulary names({"a", "b"});
      const Dfa before = as_dfa(automaton, names, {{0}, {1}}), after = as_dfa(made, names, {{0}, {1}});
      ASSERT_EQ(before.initial().index, first);
      ASSERT_FALSE(difference(before, after).has_value()) << "automaton " << i << " from " << first;
      const Dfa smallest = minimize(before);
      ASSERT_FALSE(difference(before, smallest).has_value()) << "automaton " << i << " from " << first;
      ASSERT_LE(smallest.states(), after.states());
    }
  }
}

TEST(Minimize, EndsWhenItsEffortIsSpent) {
  // A cycle: refined, not done in one pass.
  const Table third{{{1, 1, 1, 1}, {2, 2, 2, 2}, {0, 0, 0, 0}}, {true, false, false}};
  const Dfa dfa = as_dfa(symbolic(third), ltl::Vocabulary({"a", "b"}), {{0}, {1}});
  Budget enough(100, SIZE_MAX, {}), none(0, SIZE_MAX, {});
  EXPECT_EQ(minimize(dfa, enough).states(), 3U);
  EXPECT_THROW(minimize(dfa, none), Budget::Exceeded);
}

// Distinguishability by definition: every two states of a translation are told apart by some word.
TEST(Minimize, StatesOfATranslationAreDistinguishable) {
  ltl::Random random(14);
  for (int i = 0; i < 200; ++i) {
    ltl::Arena arena(ltl::Vocabulary({"a", "b"}));
    const Dfa dfa = ltlf_to_dfa(ltl::random_formula(random, arena, {.size = 14, .atoms = 2}));
    Table table;
    for (std::uint32_t q = 0; q < dfa.states(); ++q) {
      table.next.emplace_back();
      for (std::uint32_t bits = 0; bits < letters; ++bits) {
        ltl::Letter letter;
        if ((bits & 1U) != 0) letter.insert({0});
        if ((bits & 2U) != 0) letter.insert({1});
        table.next.back()[bits] = dfa.next(StateId{q}, letter).index;
      }
      table.accepting.push_back(dfa.is_accepting(StateId{q}));
    }
    const std::vector<std::size_t> classes = moore(table);
    ASSERT_EQ(std::set(classes.begin(), classes.end()).size(), dfa.states()) << "formula " << i;
  }
}

}  // namespace
}  // namespace waymark::automata
