// What is merged and pruned by simulation, letter by letter from the relations, and marks that nothing needs.
#include "libautomata/omega/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/fewest_marks.hpp"
#include "libautomata/omega/greatest_simulation.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

class BySimulation : public ::testing::Test {
 protected:
  static constexpr int automata = testing::scaled(3'000);
  using Edge = std::tuple<std::uint32_t, std::uint32_t, Branch>;  // state, letter, branch

  // Small automata with some states that simulate each other, another state than the first being initial.
  template <class Check>
  void for_each_automaton(std::uint64_t drawn_with, const Check& check) {
    ltl::Random random(drawn_with);
    for (int i = 0; i < automata; ++i) {
      TransitionRelation a = random_automaton(random, testing::letters_vocabulary(2),
                                              {.states = static_cast<std::uint32_t>(2 + random.below(5)),
                                               .atoms = 1 + random.below(2),
                                               .sets = static_cast<std::uint32_t>(random.below(3)),
                                               .empty = 0.4,
                                               .generic = false})
                                 .transitions();
      a.initial = static_cast<std::uint32_t>(random.below(a.states()));
      check(a, "seed " + std::to_string(drawn_with) + ", automaton " + std::to_string(i));
    }
  }
  static std::vector<Branch> on_letter(const TransitionRelation& a, std::uint32_t q, std::uint32_t letter) {
    const auto holds = [&](Mtbdd::Variable v) { return (letter >> v & 1U) != 0; };
    const auto choice = a.choices[Mtbdd::payload(a.diagram.evaluate(a.roots[q], holds))];
    return {choice.begin(), choice.end()};
  }
  static std::set<Edge> edges(const TransitionRelation& a) {
    std::set<Edge> out;
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (std::uint32_t letter = 0; letter < 4; ++letter)
        for (const Branch& b : on_letter(a, q, letter)) out.emplace(q, letter, b);
    return out;
  }
  // How many classes states fall into that are related both ways, within a colour.
  static std::size_t classes(const StatePairs& below, const std::vector<bool>& colour) {
    std::size_t out = 0;
    for (std::uint32_t q = 0; q < below.states(); ++q) {
      bool fresh = true;
      for (std::uint32_t r = 0; r < q; ++r) fresh = fresh && !(colour[q] == colour[r] && below(q, r) && below(r, q));
      out += fresh ? 1 : 0;
    }
    return out;
  }
  Budget budget_;
};

TEST_F(BySimulation, StatesThatSimulateEachOtherBecomeOne) {
  std::size_t merged = 0, merged_backwards = 0, kept_apart = 0;
  for_each_automaton(101, [&](const TransitionRelation& a, const std::string& which) {
    const StatePairs after = greatest_simulation(a, budget_), before = greatest_reverse_simulation(a, budget_);
    const std::vector<bool> one_colour(a.states(), false);
    std::vector<bool> colours(a.states(), false);
    for (std::size_t q = 0; q < a.states(); ++q) colours[q] = q % 2 == 1;
    EXPECT_EQ(Simulations(a, budget_).quotient().states(), classes(after, one_colour)) << which;
    EXPECT_EQ(Simulations(a, budget_).reverse_quotient(one_colour).states(), classes(before, one_colour)) << which;
    EXPECT_EQ(Simulations(a, budget_).reverse_quotient(colours).states(), classes(before, colours)) << which;
    const auto relation = direct_simulation(a, budget_);
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (std::uint32_t r = 0; r < a.states(); ++r) EXPECT_EQ(relation[q][r], after(q, r)) << which;
    merged += classes(after, one_colour) < a.states() ? 1 : 0;
    merged_backwards += classes(before, one_colour) < a.states() ? 1 : 0;
    kept_apart += classes(before, one_colour) < classes(before, colours) ? 1 : 0;
  });
  EXPECT_GT(merged, automata / 20);
  EXPECT_GT(merged_backwards, automata / 100);
  EXPECT_GT(kept_apart, automata / 200);
}

// One at a time, in their order: of branches that are no better than each other one stays. Branches that leave their
// component may carry any marks.
TEST_F(BySimulation, BranchesWithABetterOneAreDropped) {
  std::size_t dropped = 0;
  for_each_automaton(102, [&](const TransitionRelation& a, const std::string& which) {
    const StatePairs after = greatest_simulation(a, budget_);
    if (classes(after, std::vector<bool>(a.states(), false)) < a.states()) return;
    const Components found = components(BranchGraph(a));
    std::set<Edge> expected;
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (std::uint32_t letter = 0; letter < 4; ++letter) {
        std::vector<Branch> left = on_letter(a, q, letter);
        for (std::size_t i = 0; i < left.size();) {
          const bool worse = std::any_of(left.begin(), left.end(), [&](const Branch& other) {
            const bool marked_enough = found.of[other.target] != found.of[q] || other.marks.includes(left[i].marks);
            return other != left[i] && marked_enough && after(left[i].target, other.target);
          });
          worse ? void(left.erase(left.begin() + static_cast<std::ptrdiff_t>(i))) : void(++i);
        }
        for (const Branch& b : left) expected.emplace(q, letter, b);
      }
    EXPECT_EQ(edges(Simulations(a, budget_).quotient()), expected) << which;
    dropped += expected.size() < edges(a).size() ? 1 : 0;
  });
  EXPECT_GT(dropped, automata / 20);
}

TEST_F(BySimulation, BranchesAreDroppedThatAStateStrictlyAboveOvertakes) {
  std::size_t dropped = 0;
  for_each_automaton(103, [&](const TransitionRelation& a, const std::string& which) {
    const StatePairs after = greatest_simulation(a, budget_), before = greatest_reverse_simulation(a, budget_);
    std::set<Edge> expected = edges(a);
    for (const auto& [p, letter, b] : edges(a))
      for (std::uint32_t q = 0; q < a.states(); ++q) {
        if (!before(p, q) || before(q, p)) continue;
        for (const Branch& other : on_letter(a, q, letter))
          if (other.marks.includes(b.marks) && after(b.target, other.target)) expected.erase({p, letter, b});
      }
    EXPECT_EQ(edges(Simulations(a, budget_).without_overtaken()), expected) << which;
    dropped += expected.size() < edges(a).size() ? 1 : 0;
  });
  EXPECT_GT(dropped, automata / 20);
}

// By the definition: a mark of a branch goes while every cycle through the branch meets it elsewhere.
TEST_F(BySimulation, FewestMarksAreThoseThatSomeCycleNeeds) {
  std::size_t fewer = 0;
  for_each_automaton(104, [&](const TransitionRelation& a, const std::string& which) {
    std::vector<std::pair<std::uint32_t, Branch>> given;  // distinct, sorted
    for (std::uint32_t q = 0; q < a.states(); ++q)
      for (const Branch& b : branches_of(a, q)) given.emplace_back(q, b);
    std::vector<Marks> left;
    for (const auto& [q, b] : given) left.push_back(b.marks);
    for (std::uint32_t mark = 0; mark < a.acceptance.sets; ++mark)
      for (std::size_t i = 0; i < given.size(); ++i) {
        if (!left[i].contains(mark)) continue;
        std::vector<bool> reached(a.states(), false);
        reached[given[i].second.target] = true;
        for (bool grew = true; grew;) {
          grew = false;
          for (std::size_t k = 0; k < given.size(); ++k)
            if (reached[given[k].first] && !left[k].contains(mark) && !reached[given[k].second.target])
              grew = reached[given[k].second.target] = true;
        }
        if (!reached[given[i].first]) left[i] = left[i].without(Marks::of(mark));
      }
    const auto made = fewest_marks(a, budget_);
    std::set<Edge> expected;
    for (const auto& [q, letter, b] : edges(a)) {
      const auto at = std::find(given.begin(), given.end(), std::pair{q, b}) - given.begin();
      expected.emplace(q, letter, Branch{b.target, left[static_cast<std::size_t>(at)]});
    }
    EXPECT_EQ(edges(made.value_or(a)), expected) << which;
    EXPECT_EQ(made.has_value(), expected != edges(a)) << which;
    fewer += made ? 1 : 0;
  });
  EXPECT_GT(fewer, automata / 10);
}

}  // namespace
}  // namespace waymark::automata
