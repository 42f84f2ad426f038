// The composed route against products of whole automata, minimised at the end.
#include "libautomata/finite/portfolio.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace waymark::automata {
namespace {

// Conjunctions and disjunctions of random formulas that share some propositions: some so large that a first direct
// attempt fails.
TEST(FiniteRoutes, AgreeWithProductsOfTheOperands) {
  const std::vector<std::string> names{"a", "b", "c", "d", "e", "f", "g", "h"};
  ltl::Random random(31);
  std::size_t large = 0;
  for (int i = 0; i < 150; ++i) {
    ltl::Arena arena{ltl::Vocabulary(names)};
    const bool conjunction = random.chance(0.6);
    std::vector<ltl::Formula> operands;
    for (std::size_t k = 0; k < 4; ++k) {
      ltl::Arena own(ltl::Vocabulary({names[2 * k], names[2 * k + 1], names[random.below(8)]}));
      const std::size_t atoms = own.vocabulary().size();
      const ltl::Formula goal = ltl::random_formula(random, own, {.size = 8, .atoms = atoms});
      ltl::Formula late = own.atom(names[2 * k + 1]);
      for (std::size_t wait = random.below(4); wait > 0; --wait) late = ltl::weak_next(ltl::disjunction(late, goal));
      const ltl::Formula response = ltl::always(ltl::implies(own.atom(names[2 * k]), late));
      operands.push_back(ltl::transfer(random.chance(0.8) ? response : goal, arena));
    }
    const ltl::Formula f = conjunction ? ltl::conjunction(arena, operands) : ltl::disjunction(arena, operands);
    const Dfa made = ltlf_to_dfa(f);
    Dfa expected = ltlf_to_dfa(operands[0]);
    for (std::size_t k = 1; k < operands.size(); ++k) {
      const Verdict both = [](bool p, bool q) { return p && q; };
      const Verdict either = [](bool p, bool q) { return p || q; };
      const Dfa operand = ltlf_to_dfa(operands[k]);
      expected = product(expected, operand, conjunction ? both : either);
    }
    expected = minimize(expected);
    ASSERT_EQ(made.states(), expected.states()) << ltl::print(f);
    ASSERT_FALSE(difference(made, expected).has_value()) << ltl::print(f);
    large += made.states() > 100 ? 1 : 0;
  }
  EXPECT_GT(large, 5U);
}

// G (a1 -> F b1) & …: neighbours in the order of propositions, or all triggers before all responses.
TEST(FiniteRoutes, TheOrderOfPropositionsDoesNotMatter) {
  constexpr std::size_t n = 9;
  std::vector<std::string> apart;
  std::string text = "true";
  for (const char* side : {"a", "b"})
    for (std::size_t i = 1; i <= n; ++i) apart.push_back(side + std::to_string(i));
  for (std::size_t i = 1; i <= n; ++i) text += " & G (a" + std::to_string(i) + " -> F b" + std::to_string(i) + ")";
  ltl::Arena in_pairs, in_halves{ltl::Vocabulary(apart)};
  const Dfa first = ltlf_to_dfa(ltl::parse(text, in_pairs)), second = ltlf_to_dfa(ltl::parse(text, in_halves));
  EXPECT_EQ(first.states(), (1U << n) + 1);
  EXPECT_EQ(second.states(), (1U << n) + 1);
  EXPECT_FALSE(difference(first, second).has_value());
}

TEST(FiniteRoutes, EquivalencesAreOneOfTwo) {
  const auto automaton = [](const char* text) {
    ltl::Arena arena(ltl::Vocabulary({"a", "b"}));
    return ltlf_to_dfa(ltl::parse(text, arena));
  };
  EXPECT_FALSE(difference(automaton("F a <-> G b"), automaton("(F a & G b) | (G !a & F !b)")).has_value());
  EXPECT_FALSE(difference(automaton("F a ^ G b"), automaton("(F a & F !b) | (G !a & G b)")).has_value());
  EXPECT_FALSE(difference(automaton("!(X a <-> F b)"), automaton("(X a & G !b) | (!X a & F b)")).has_value());
  EXPECT_EQ(automaton("F a <-> F a").states(), 2U) << "any word but the empty one";
}

// One side is so large that the whole is not tried in one piece.
TEST(FiniteRoutes, LargeEquivalencesAreOneOfTwo) {
  std::string big = "true";
  for (const char* i : {"1", "2", "3", "4", "5", "6", "7", "8"})
    big += std::string(" & G (a") + i + " -> F b" + i + ")";
  ltl::Arena arena;
  const auto automaton = [&](const std::string& text) { return ltlf_to_dfa(ltl::parse(text, arena)); };
  const Verdict one = [](bool p, bool q) { return p != q; };
  const Dfa large = automaton(big), sometimes = automaton("F z"), never = automaton("G !z");
  const Dfa equivalent = minimize(product(large, never, one)), different = minimize(product(large, sometimes, one));
  for (const std::string& text : {"(" + big + ") <-> F z", "!((" + big + ") ^ F z)"}) {
    const Dfa made = automaton(text);
    EXPECT_EQ(made.states(), equivalent.states());
    EXPECT_FALSE(difference(made, equivalent).has_value());
  }
  for (const std::string& text : {"(" + big + ") ^ F z", "!((" + big + ") <-> F z)"}) {
    const Dfa made = automaton(text);
    EXPECT_EQ(made.states(), different.states());
    EXPECT_FALSE(difference(made, different).has_value());
  }
}

// Two states of either operand are complements of each other, so pairs of states are equal that are not one state in
// a product of automata without common propositions.
TEST(FiniteRoutes, LargeEquivalencesOfOperandsWithoutCommonPropositionsAreMinimal) {
  std::string big = "(q U r)";
  for (const char* i : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) big += std::string(" & F a") + i;
  const Verdict one = [](bool p, bool q) { return p != q; };
  for (const char* small : {"s U t", "G (s -> X t)"})
    for (const bool swapped : {false, true}) {
      ltl::Arena arena;
      const auto automaton = [&](const std::string& text) { return ltlf_to_dfa(ltl::parse(text, arena)); };
      const Dfa made =
          automaton(swapped ? std::string("(") + small + ") ^ (" + big + ")" : "(" + big + ") ^ (" + small + ")");
      const Dfa expected = minimize(product(automaton(big), automaton(small), one));
      EXPECT_EQ(made.states(), expected.states()) << small;
      EXPECT_FALSE(difference(made, expected).has_value()) << small;
    }
}

// Operands without common propositions, too large in one piece: whatever is known of each, the result is minimal.
TEST(FiniteRoutes, OperandsWithoutCommonPropositionsGiveTheMinimalAutomaton) {
  ltl::Random random(32);
  std::vector<std::string> names{"b", "c", "d", "e"};
  std::string late, never;
  for (int i = 1; i <= 8; ++i) {
    names.push_back("a" + std::to_string(i));
    late += (i > 1 ? " & F " : "F ") + names.back();
    never += (i > 1 ? " | G " : "G ") + names.back();
  }
  for (int i = 0; i < 150; ++i) {
    const bool all = i % 2 == 0;
    ltl::Arena arena{ltl::Vocabulary(names)};
    std::vector<ltl::Formula> operands{ltl::parse(all ? late : never, arena)};
    for (const std::size_t first : {0U, 2U}) {
      ltl::Arena own(ltl::Vocabulary({names[first], names[first + 1]}));
      operands.push_back(ltl::transfer(ltl::random_formula(random, own, {.size = 7, .atoms = 2}), arena));
    }
    const Verdict both = [](bool p, bool q) { return p && q; }, either = [](bool p, bool q) { return p || q; };
    Dfa expected = ltlf_to_dfa(operands[0]);
    for (const std::size_t k : {1U, 2U}) expected = product(expected, ltlf_to_dfa(operands[k]), all ? both : either);
    expected = minimize(expected);
    const ltl::Formula f = all ? ltl::conjunction(arena, operands) : ltl::disjunction(arena, operands);
    const Dfa made = ltlf_to_dfa(f);
    ASSERT_EQ(made.states(), expected.states()) << ltl::print(f);
    ASSERT_FALSE(difference(made, expected).has_value()) << ltl::print(f);
  }
}

TEST(FiniteRoutes, OperandsWithoutPropositionsAreOperandsToo) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse("X X X true & N N N N false & F a & F b & G (c -> F d)", arena);
  const ltl::Formula g = ltl::parse("F a & X X X true & F b & G (c -> F d) & !X X X X true", arena);
  const Dfa first = ltlf_to_dfa(f), second = ltlf_to_dfa(g);
  EXPECT_EQ(first.states(), second.states());
  EXPECT_FALSE(difference(first, second).has_value());
}

// Disjoint groups, one of which is settled at once: no product of the others is made.
TEST(FiniteRoutes, AnImpossibleOperandIsNoticedInTime) {
  ltl::Arena arena;
  std::string text = "F (z & !z)";
  for (int i = 0; i < 12; ++i) text += " & F p" + std::to_string(i);
  EXPECT_EQ(ltlf_to_dfa(ltl::parse(text, arena)).states(), 1U);
}

// Operands that share a proposition: neither route stays within the limit, and both are tried once only.
TEST(FiniteRoutes, LimitsEndBothRoutes) {
  ltl::Arena arena;
  std::string text = "true";
  for (int i = 0; i < 12; ++i) text += " & G (z -> F p" + std::to_string(i) + ")";
  const ltl::Formula f = ltl::parse(text, arena);
  const auto limited = ltlf_to_dfa(f, {.states = 1000});
  ASSERT_TRUE(std::holds_alternative<Exhausted>(limited));
  EXPECT_GT(std::get<Exhausted>(limited).states, 1000U);
  EXPECT_EQ(std::get<Dfa>(ltlf_to_dfa(f, {.states = 1'000'000})).states(), (1U << 12U) + 1);
}

// In one piece these take at least 870 states before minimisation, more than the limit; their operands take fewer.
TEST(FiniteRoutes, OperandsAreTranslatedWhereTheWholeExceedsTheLimit) {
  const std::string one_of_two =
      "((X false <-> (!c U (X N X X !N b))) | G((a | X N F b) <-> X N X(a M c)) | F(!b R (N N F N !N b)))";
  const std::string late =
      "(((F a) M (G(N F X d <-> F(a U (X a))))) & G((d U (N X F c)) <-> F X(a <-> F a)) & "
      "(F X N false | (c <-> N(c <-> G c))))";
  const std::string response = "(G(e -> F f) & G(g -> F h) & G(i -> F j) & G(k -> F l) & G(m -> F n) & G(o -> F p))";
  const std::pair<std::string, std::size_t> table[] = {{one_of_two, 200},
                                                       {late, 200},
                                                       {one_of_two + " & G(d -> F e)", 200},
                                                       {"!(" + late + " & F z)", 200},
                                                       {response + " ^ " + one_of_two, 400},
                                                       {one_of_two + " ^ " + response, 400},
                                                       {response + " ^ (" + one_of_two + " & X e)", 400},
                                                       {"!(" + response + " ^ !" + late + ")", 400}};
  for (const auto& [text, limit] : table) {
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(text, arena);
    const auto limited = ltlf_to_dfa(f, {.states = limit});
    ASSERT_TRUE(std::holds_alternative<Dfa>(limited)) << text;
    EXPECT_FALSE(difference(std::get<Dfa>(limited), ltlf_to_dfa(f)).has_value()) << text;
  }
}

TEST(FiniteRoutes, BytesAreTheSameOnEachRun) {
  const std::string text = "(F a & G (b -> F c) | G (d -> X a)) & (F e U f) & G (g -> N (h | a)) & (F c <-> F h)";
  ltl::Arena one, two;
  EXPECT_EQ(write_hoa(ltlf_to_dfa(ltl::parse(text, one))), write_hoa(ltlf_to_dfa(ltl::parse(text, two))));
}

}  // namespace
}  // namespace waymark::automata
