// Degeneralisation against its definition, written with single letters and lists of copies.
#include "libautomata/omega/degeneralize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

constexpr std::uint64_t seed_of_sets = 81;
constexpr std::uint32_t four_letters = 4;  // of two propositions

using Copy = std::pair<std::uint32_t, std::uint32_t>;  // state, level

// [BBDLF13, Sec. 4]: level l waits for the set at place l of the order; the last level has met them all.
class ByDefinition {
 public:
  ByDefinition(const TransitionRelation& given, const LevelRule& rule) : given_(given), rule_(rule) {
    const std::size_t states = given.states();
    for (std::uint32_t set = 0; set < sets(); ++set) order_.push_back(rule.descending ? sets() - 1 - set : set);
    reaches_.assign(states, std::vector<bool>(states, false));
    for (std::uint32_t q = 0; q < states; ++q)
      for (const Branch& b : branches_of(given, q)) reaches_[q][b.target] = true;
    for (std::uint32_t k = 0; k < states; ++k)
      for (std::uint32_t q = 0; q < states; ++q)
        for (std::uint32_t r = 0; r < states; ++r)
          if (reaches_[q][k] && reaches_[k][r]) reaches_[q][r] = true;
  }

  TransitionRelation result() {
    build();
    entries_ = highest_;  // into copies that are there anyway
    return build();
  }

 private:
  std::uint32_t sets() const { return given_.acceptance.sets; }
  bool one_component(std::uint32_t q, std::uint32_t r) const { return q == r || (reaches_[q][r] && reaches_[r][q]); }
  std::vector<Marks> marks_inside(std::uint32_t q, bool of_component) const {
    std::vector<Marks> out;
    for (std::uint32_t p = 0; p < given_.states(); ++p)
      for (const Branch& b : branches_of(given_, p))
        if ((of_component ? one_component(p, q) : p == q) && one_component(p, b.target)) out.push_back(b.marks);
    return out;
  }
  bool is_accepting(std::uint32_t q) const {
    Marks met;
    for (const Marks m : marks_inside(q, true)) met = met | m;
    return reaches_[q][q] && met == Marks::first(sets());
  }
  bool counts(std::uint32_t q) const {
    const auto inside = marks_inside(q, true);
    return std::any_of(inside.begin(), inside.end(), [&](Marks m) { return m != Marks::first(sets()); });
  }
  Marks shared(std::uint32_t q) const {
    Marks out = Marks::first(sets());
    for (const Marks m : marks_inside(q, false)) out = out & m;
    return out;
  }
  std::uint32_t advanced(std::uint32_t level, Marks met) const {
    while (level < sets() && met.contains(order_[level])) ++level;
    return level;
  }
  std::uint32_t entry(std::uint32_t q) const {
    if (!is_accepting(q)) return 0;
    if (!counts(q)) return sets();
    if (entries_.contains(q)) return entries_.at(q);
    return rule_.look_ahead ? advanced(0, shared(q)) : 0;
  }
  std::uint32_t inner(Copy from, const Branch& b) const {
    const auto [q, level] = from;
    if (!is_accepting(q)) return 0;
    if (!counts(q)) return sets();
    Marks met = b.marks;
    const bool again = level == sets();
    if (again && rule_.look_ahead && !rule_.count_twice) met = met.without(shared(q));
    const std::uint32_t reached = advanced(again ? 0 : level, met);
    return rule_.look_ahead ? advanced(reached, shared(b.target)) : reached;
  }

  TransitionRelation build() {
    TransitionRelation out;
    out.acceptance = Acceptance::buchi();
    std::vector<Copy> copies{{given_.initial, entry(given_.initial)}};
    const auto number = [&](Copy c) {
      const auto at = std::find(copies.begin(), copies.end(), c);
      if (at == copies.end()) return copies.push_back(c), static_cast<std::uint32_t>(copies.size() - 1);
      return static_cast<std::uint32_t>(at - copies.begin());
    };
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const Copy from = copies[i];
      std::array<Mtbdd::Node, four_letters> leaf;
      for (std::uint32_t letter = 0; letter < four_letters; ++letter) {
        const auto holds = [&](Mtbdd::Variable v) { return (letter >> v & 1U) != 0; };
        std::vector<Branch> branches;
        for (const Branch& b :
             given_.choices[Mtbdd::payload(given_.diagram.evaluate(given_.roots[from.first], holds))]) {
          const bool stays = one_component(from.first, b.target);
          const std::uint32_t level = stays ? inner(from, b) : entry(b.target);
          if (stays) highest_[b.target] = std::max(highest_[b.target], level);
          branches.push_back(
              {number({b.target, level}), from.second == sets() && is_accepting(from.first) ? Marks::of(0) : Marks()});
        }
        leaf[letter] = Mtbdd::terminal(out.choices.intern(branches));
      }
      out.roots.push_back(
          out.diagram.make(0, out.diagram.make(1, leaf[0], leaf[2]), out.diagram.make(1, leaf[1], leaf[3])));
    }
    return out;
  }

  const TransitionRelation& given_;
  LevelRule rule_;
  std::vector<std::uint32_t> order_;
  std::vector<std::vector<bool>> reaches_;
  std::map<std::uint32_t, std::uint32_t> highest_, entries_;  // levels
};

// Names of states aside; where a letter leads to several states, by their numbers.
bool same(const TransitionRelation& a, const TransitionRelation& b) {
  if (is_deterministic(a) && is_deterministic(b)) return identical(canonical(a), canonical(b));
  const auto shape = [](const TransitionRelation& automaton) {
    std::vector<std::vector<std::uint32_t>> out;  // by state: branches, those with a mark, to itself, to others of them
    for (std::uint32_t q = 0; q < automaton.states(); ++q) {
      auto& counts = out.emplace_back(std::vector<std::uint32_t>(4, 0));
      for (const Branch& branch : branches_of(automaton, q)) {
        ++counts[0];
        counts[1] += branch.marks.empty() ? 0 : 1;
        counts[2] += branch.target == q ? 1 : 0;
        counts[3] += static_cast<std::uint32_t>(branches_of(automaton, branch.target).size());
      }
    }
    std::sort(out.begin(), out.end());
    return out;
  };
  return shape(a) == shape(b);
}

TEST(Degeneralisation, IsTheOneOfTheDefinition) {
  ltl::Random random(seed_of_sets);
  const auto vocabulary = testing::letters_vocabulary(2);
  std::size_t more_copies = 0, marked = 0;
  for (std::size_t i = 0; i < (testing::sanitized ? 60U : 600U); ++i) {
    const Automaton drawn = random_automaton(random, vocabulary,
                                             {.states = static_cast<std::uint32_t>(1 + random.below(6)),
                                              .sets = static_cast<std::uint32_t>(random.below(4)),
                                              .branches = 1 + random.below(2),
                                              .marked = i % 3 == 0 ? 0.8 : 0.4,
                                              .empty = 0.5,
                                              .generic = false});
    const TransitionRelation& given = drawn.transitions();
    for (unsigned bits = 0; bits < 8; ++bits) {
      const LevelRule rule{(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
      Budget budget;
      const TransitionRelation made = degeneralize(given, rule, budget), expected = ByDefinition(given, rule).result();
      ASSERT_TRUE(same(made, expected)) << "seed " << seed_of_sets << ", automaton " << i << ", rule " << bits << '\n'
                                        << write_hoa(drawn) << write_hoa(as_automaton(made, vocabulary, {{0}, {1}}))
                                        << write_hoa(as_automaton(expected, vocabulary, {{0}, {1}}));
      more_copies += made.states() > given.states() ? 1 : 0;
      for (std::uint32_t q = 0; q < made.states(); ++q)
        for (const Branch& b : branches_of(made, q)) marked += b.marks.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(more_copies, 100U);
  EXPECT_GT(marked, 100U);
}

TEST(Degeneralisation, CountsCopiesAsStates) {
  ltl::Random random(seed_of_sets);
  const Automaton drawn = random_automaton(random, testing::letters_vocabulary(2),
                                           {.states = 5, .sets = 3, .branches = 2, .empty = 0.1, .generic = false});
  Budget any;
  degeneralize(drawn.transitions(), {}, any);
  Budget enough(SIZE_MAX, any.states(), {}), few(SIZE_MAX, any.states() - 1, {});
  EXPECT_NO_THROW(degeneralize(drawn.transitions(), {}, enough));
  EXPECT_THROW(degeneralize(drawn.transitions(), {}, few), Budget::Exceeded);
}

TEST(Degeneralisation, ASetIsAddedWhereThereIsNone) {
  ltl::Random random(seed_of_sets);
  const auto vocabulary = testing::letters_vocabulary(2);
  for (std::uint32_t sets = 0; sets < 3; ++sets) {
    const TransitionRelation given =
        random_automaton(random, vocabulary, {.states = 4, .sets = sets, .empty = 0.3, .generic = false}).transitions();
    const TransitionRelation made = with_one_set(given);
    EXPECT_EQ(made.acceptance.sets, std::max(1U, sets));
    EXPECT_EQ(made.states(), given.states());
    const Automaton before = as_automaton(given, vocabulary, {{0}, {1}}),
                    after = as_automaton(made, vocabulary, {{0}, {1}});
    for (const ltl::Lasso& word : testing::all_lassos({.length = 3, .atoms = 2}))
      ASSERT_EQ(accepts(before, word), accepts(after, word)) << sets << ' ' << ltl::show(word, vocabulary);
    for (std::uint32_t q = 0; q < made.states(); ++q)
      for (const Branch& b : branches_of(made, q)) EXPECT_TRUE(sets > 0 || b.marks == Marks::of(0));
  }
}

}  // namespace
}  // namespace waymark::automata
