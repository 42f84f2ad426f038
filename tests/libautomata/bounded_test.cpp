// Automata of bounded operators: sizes that grow with the bound and not with its power, and languages by definition.
#include <gtest/gtest.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

std::string response(std::size_t k) { return "G(a -> F<=" + std::to_string(k) + " b)"; }

TEST(Bounded, ResponsesHaveAStateForEachStepThatIsLeft) {
  for (const std::size_t k : {2U, 5U, 20U, 60U, 1000U}) {
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(response(k), arena);
    EXPECT_EQ(ltlf_to_dfa(f).states(), k + 3) << k;
    if (k > 60) continue;  // seconds under sanitizers
    EXPECT_EQ(ltl_to_tgba(f).states(), k + 1) << k;
  }
}

TEST(Bounded, ConstructionsMakeFewStatesOnTheWay) {
  ltl::Arena arena;
  const ltl::Limits few{.states = 1000};
  EXPECT_TRUE(std::holds_alternative<Dfa>(ltlf_to_dfa(ltl::parse(response(100), arena), few)));
  EXPECT_TRUE(std::holds_alternative<Translated>(ltl_to_tgba(ltl::parse(response(100), arena), few)));
  EXPECT_TRUE(std::holds_alternative<Dfa>(ltlf_to_dfa(ltl::parse("G(a -> F[2,5](b & F[0,10] c))", arena), few)));
}

// Formulas of bounded operators, nested and next to each other.
ltl::Formula some_bounded(ltl::Random& random, ltl::Arena& arena, std::size_t depth) {
  const auto below = [&] { return some_bounded(random, arena, depth - 1); };
  if (depth == 0) return arena.atom(ltl::Proposition{static_cast<std::uint32_t>(random.below(2))});
  switch (random.below(7)) {
    case 0: return ltl::negate(below());
    case 1: return ltl::conjunction(below(), below());
    case 2: return ltl::next(below());
    case 3: return ltl::always(below());
    case 4: return ltl::until(below(), below());
    case 5: return ltl::eventually_within(1 + random.below(3), below());
    default: return ltl::always_within(1 + random.below(3), below());
  }
}

TEST(Bounded, LanguagesAreThoseOfTheDefinition) {
  ltl::Random random(34);
  const std::vector<ltl::Trace> words = testing::all_traces({.length = 5, .atoms = 2});
  const std::vector<ltl::Lasso> lassos = testing::all_lassos({.length = 4, .atoms = 2});
  for (int i = 0; i < 60; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const ltl::Formula f = some_bounded(random, arena, 4);
    const auto dfa = ltlf_to_dfa(f, {.states = 20'000});
    if (const Dfa* made = std::get_if<Dfa>(&dfa)) {
      for (const ltl::Trace& word : words)
        ASSERT_EQ(accepts(*made, word), ltl::holds(word, f)) << testing::show(f, word) << " seed 34, " << i;
    }
    const auto tgba = ltl_to_tgba(f, {.states = 2'000});
    if (const auto* made = std::get_if<Translated>(&tgba)) {
      for (const ltl::Lasso& word : lassos)
        ASSERT_EQ(accepts(made->automaton, word), ltl::holds(word, f)) << testing::show(f, word) << " seed 34, " << i;
    }
  }
}

}  // namespace
}  // namespace waymark::automata
