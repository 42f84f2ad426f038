// Products of deterministic automata, and parity from any condition: against the definition of acceptance on all small
// lassos, by emptiness of the differences, and against formulas.
#include "libautomata/deterministic/paritise.hpp"

#include <gtest/gtest.h>

#include "libautomata/deterministic/combination.hpp"
#include "libautomata/deterministic/split.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libautomata/omega/recurrence.hpp"
#include "libautomata/omega/weak.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

const ltl::Vocabulary ab({"a", "b"});
const std::vector<ltl::Proposition> reads{{0}, {1}};

RandomAutomaton shape(int i) {
  return {.states = static_cast<std::uint32_t>(1 + i % 5),
          .sets = static_cast<std::uint32_t>(i % 6),
          .branches = 1,
          .marked = i % 3 == 0 ? 0.5 : 0.25,
          .empty = i % 2 == 0 ? 0.0 : 0.15,
          .generic = i % 7 != 0};
}

bool within(const Automaton& a, const Automaton& b) {
  Budget budget;
  const Automaton outside = complement(*Deterministic::checked(b)).automaton();
  return is_empty(intersection(a, outside, budget).transitions());
}

TEST(Paritise, KeepsTheLanguageOfRandomAutomata) {
  constexpr std::uint64_t seed = 71;
  ltl::Random random(seed);
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  for (int i = 0; i < 400; ++i) {
    const Automaton from = random_automaton(random, ab, shape(i));
    Budget budget;
    const Automaton made = as_automaton(paritise(from.transitions(), budget), ab, from.reads());
    ASSERT_TRUE(Dpa::checked(made)) << "seed " << seed << ", automaton " << i << '\n' << write_hoa(from);
    ASSERT_TRUE(within(made, from)) << "seed " << seed << ", automaton " << i << '\n' << write_hoa(from);
    ASSERT_TRUE(within(from, made)) << "seed " << seed << ", automaton " << i << '\n' << write_hoa(from);
    if (i % 8 != 0) continue;
    for (const ltl::Lasso& word : words)
      ASSERT_EQ(referee::accepts(made, word), referee::accepts(from, word))
          << write_hoa(from) << "on " << ltl::show(word, ab);
  }
}

// [CCF21]: where the cycles of each state are ordered there is nothing to copy.
TEST(Paritise, CopiesNoStateOfAParityAutomaton) {
  ltl::Random random(72);
  for (int i = 0; i < 200; ++i) {
    const std::uint32_t sets = static_cast<std::uint32_t>(i % 5);
    TransitionRelation from =
        random_automaton(random, ab, {.states = 6, .sets = sets, .branches = 1, .generic = false}).transitions();
    from.acceptance = Acceptance::parity(i % 2 == 0 ? Acceptance::Extreme::Min : Acceptance::Extreme::Max,
                                         i % 4 < 2 ? Acceptance::Parity::Even : Acceptance::Parity::Odd, sets);
    Budget budget;
    ASSERT_EQ(paritise(from, budget).states(), canonical(from).states()) << i;
  }
}

// One state, all sets of marks as letters: a copy per leaf of the Zielonka tree.
TEST(Paritise, CopiesAStateOncePerLeaf) {
  const struct {
    Acceptance acceptance;
    std::size_t states;
  } table[] = {
      {Acceptance::generalized_buchi(4), 4},
      {Acceptance::rabin(1), 1},
      {Acceptance::rabin(2), 2},
      {Acceptance::streett(2), 2},
      {Acceptance::rabin(3), 6},
      {Acceptance::streett(3), 6},
      {Acceptance::all(), 1},
      {Acceptance::co_buchi(), 1},
  };
  for (const auto& row : table) {
    TransitionRelation from;
    from.acceptance = row.acceptance;
    std::vector<Mtbdd::Node> nodes;
    for (std::uint64_t bits = 0; bits < std::uint64_t{1} << row.acceptance.sets; ++bits)
      nodes.push_back(Mtbdd::terminal(from.choices.intern({{0, Marks::from_bits(bits)}})));
    for (Mtbdd::Variable v = row.acceptance.sets; v-- > 0;)
      for (std::size_t i = 0; i < std::size_t{1} << v; ++i)
        nodes[i] = from.diagram.make(v, nodes[i], nodes[i + (std::size_t{1} << v)]);
    from.roots = {nodes.front()};
    Budget budget;
    EXPECT_EQ(paritise(from, budget).states(), row.states) << print(row.acceptance.condition);
  }
}

TEST(Paritise, StopsAtItsLimits) {
  ltl::Random random(73);
  const Automaton from = random_automaton(random, ab, {.states = 6, .sets = 4, .branches = 1, .empty = 0});
  Budget few(SIZE_MAX, 3, {});
  EXPECT_THROW(paritise(from.transitions(), few), Budget::Exceeded);
}

Condition random_combination(ltl::Random& random, std::uint32_t parts, int depth) {
  if (depth == 0 || random.below(4) == 0) {
    const auto part = static_cast<std::uint32_t>(random.below(parts));
    return random.below(4) == 0 ? Condition::fin(part) : Condition::inf(part);
  }
  std::vector<Condition> operands{random_combination(random, parts, depth - 1),
                                  random_combination(random, parts, depth - 1)};
  return random.below(2) == 0 ? Condition::all_of(std::move(operands)) : Condition::any_of(std::move(operands));
}

TEST(Combination, IsTheBooleanOneOfTheLanguages) {
  constexpr std::uint64_t seed = 74;
  ltl::Random random(seed);
  const auto words = testing::all_lassos({.length = 3, .atoms = 2});
  for (int i = 0; i < 200; ++i) {
    std::vector<Automaton> automata;
    std::vector<Operand> parts;
    const std::uint32_t count = 1 + static_cast<std::uint32_t>(i % 3);
    for (std::uint32_t k = 0; k < count; ++k) {
      RandomAutomaton options = shape(i + static_cast<int>(k));
      options.states = std::min(options.states, 3U);
      options.sets = std::min(options.sets, 2U);
      automata.push_back(random_automaton(random, ab, options));
      TransitionRelation all_variables = automata.back().transitions();
      Mtbdd diagram;
      all_variables.roots = diagram.import(
          all_variables.diagram, all_variables.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
          [&](Mtbdd::Variable v) { return automata.back().reads()[v].index; });
      all_variables.diagram = std::move(diagram);
      parts.push_back({std::move(all_variables), false});
    }
    const Condition over = random_combination(random, count, 3);
    Budget budget;
    const TransitionRelation product = combination(parts, over, budget);
    ASSERT_TRUE(is_deterministic(product));
    const Automaton made = as_automaton(product, ab, reads);
    for (const ltl::Lasso& word : words) {
      Marks accepting;
      for (std::uint32_t k = 0; k < count; ++k)
        if (accepts(automata[k], word)) accepting = accepting | Marks::of(k);
      ASSERT_EQ(accepts(made, word), over.holds(accepting))
          << "seed " << seed << ", round " << i << ", " << print(over) << " on " << ltl::show(word, ab) << '\n'
          << write_hoa(made);
    }
  }
}

// G F e by the letters that e looks back at: as many states as there are pasts that make a difference.
TEST(Recurring, LooksBackAsFarAsItMust) {
  const struct {
    const char* formula;
    std::size_t states;
  } table[] = {{"a", 1}, {"a & X b", 2}, {"a & X X b", 4}, {"a U b", 2}, {"a & X(b & X a)", 4}};
  const auto words = testing::all_lassos({.length = 4, .atoms = 2});
  for (const auto& row : table) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const ltl::Formula e = ltl::parse(row.formula, arena);
    Budget budget;
    const auto made = recurring(weak_deterministic(e, reads, budget), budget);
    ASSERT_TRUE(made) << row.formula;
    EXPECT_EQ(made->states(), row.states) << row.formula;
    const ltl::Formula f = ltl::always(ltl::eventually(e));
    for (const ltl::Lasso& word : words)
      ASSERT_EQ(accepts(as_automaton(*made, ab, reads), word), ltl::holds(word, f)) << testing::show(f, word);
  }
  ltl::Arena arena(testing::letters_vocabulary(2));
  Budget budget;
  EXPECT_FALSE(recurring(weak_deterministic(arena.constant(true), reads, budget), budget));
}

TEST(Split, ListsNoPartTwice) {
  const struct {
    const char* formula;
    Split::Late late;
    std::size_t parts;
    const char* over;
  } table[] = {
      {"F G a | F G b", Split::Late::Each, 2, "Inf(0) | Inf(1)"},
      {"F G a | F G b", Split::Late::Together, 1, "Inf(0)"},
      {"F(G a | G b)", Split::Late::Each, 2, "Inf(0) | Inf(1)"},
      {"(G F a & F G b) | (F G !a & G F !b)", Split::Late::Each, 2, "Inf(0) & Inf(1) | Fin(0) & Fin(1)"},
      {"F a & G b & G F a", Split::Late::Each, 2, "Inf(0) & Inf(1)"},
      {"X(G F a | F b)", Split::Late::Each, 2, "Inf(0) | Inf(1)"},
      {"G(a -> F b)", Split::Late::Each, 1, "Inf(0)"},
  };
  for (const auto& row : table) {
    ltl::Arena arena;
    const Split split(ltl::nnf(ltl::parse(row.formula, arena)), row.late);
    EXPECT_EQ(split.parts().size(), row.parts) << row.formula;
    EXPECT_EQ(print(split.over()), row.over) << row.formula;
  }
}

ltl::Formula random_boolean(ltl::Random& random, ltl::Arena& arena, int depth) {
  static const char* const parts[] = {"G F a",         "F G b",        "G F(a & X b)",  "F a",
                                      "G b",           "b U a",        "G(a -> F b)",   "F(a & X b)",
                                      "X a",           "F G(a | X b)", "G F c",         "F(a & G F c)",
                                      "G(b | F G !c)", "F(b & X F c)", "G F(a | G !c)", "F G(c -> X b)"};
  if (depth == 0) return ltl::parse(parts[random.below(std::size(parts))], arena);
  const ltl::Formula left = random_boolean(random, arena, depth - 1);
  const ltl::Formula right = random_boolean(random, arena, depth - 1);
  switch (random.below(5)) {
    case 0: return ltl::exclusive_or(left, right);
    case 1:
    case 2: return ltl::conjunction(left, right);
    default: return ltl::disjunction(left, right);
  }
}

TEST(LtlToParity, HasTheLanguageOfTheTableauOnBooleanCombinations) {
  constexpr std::uint64_t seed = 75;
  ltl::Random random(seed);
  for (int i = 0; i < (testing::sanitized ? 9 : 90); ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const ltl::Formula f = random_boolean(random, arena, 1 + i % 3);
    const Automaton yes = ltl_to_tgba(f), no = ltl_to_tgba(ltl::negate(f));
    for (const auto& made : {ltl_to_parity(f, {}), ltl_to_generic(f, {})}) {
      const Automaton& automaton = std::get<Translated>(made).automaton;
      Budget budget;
      ASSERT_TRUE(is_empty(intersection(automaton, no, budget).transitions()))
          << ltl::print(f) << " accepts too much; seed " << seed << ", formula " << i;
      ASSERT_TRUE(within(yes, automaton)) << ltl::print(f) << " accepts too little; seed " << seed << ", formula " << i;
    }
  }
}

}  // namespace
}  // namespace waymark::automata
