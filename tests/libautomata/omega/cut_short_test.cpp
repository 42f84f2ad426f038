// A reduction says that it is complete exactly where the limit allows all the steps that it takes without a limit. Cut
// short or not, what comes out has the language of what went in.
#include <gtest/gtest.h>

#include <string>

#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/state_merging.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

class CutShort : public ::testing::Test {
 protected:
  static constexpr std::uint64_t seed = 71;
  const ltl::Vocabulary vocabulary_ = testing::letters_vocabulary(2);
  const std::vector<ltl::Proposition> reads_{{0}, {1}};
  const std::vector<ltl::Lasso> words_ = testing::all_lassos({.length = 3, .atoms = 2});
  std::size_t steps_ = 0;  // of all reductions, without a limit
  static constexpr std::size_t some_steps = waymark::testing::sanitized ? 100 : 500;

  // For `tried` limits below the steps that are needed, the last one among them, and for those steps.
  template <class Reduction>
  void is_told(const TransitionRelation& given, const Reduction& reduction, const std::string& which,
               std::size_t tried) {
    Budget unlimited;
    const Reduced whole = reduction(unlimited);
    ASSERT_TRUE(whole.complete) << which;
    const std::size_t needed = SIZE_MAX - unlimited.steps_left();
    steps_ += needed;
    const Automaton before = as_automaton(given, vocabulary_, reads_);
    for (std::size_t i = 0; i <= tried; ++i) {
      const std::size_t limit = i == tried ? needed : needed > i ? needed - 1 - i * (needed - 1) / tried : 0;
      if (i < tried && needed == 0) continue;
      Budget budget(limit, SIZE_MAX, {});
      const Reduced made = reduction(budget);
      ASSERT_EQ(made.complete, limit >= needed) << which << ", limit " << limit << " of " << needed;
      ASSERT_GE(made.automaton.states() + 1, whole.automaton.states()) << which << ", limit " << limit;
      ASSERT_TRUE(limit < needed || identical(canonical(made.automaton), canonical(whole.automaton))) << which;
      const Automaton after = as_automaton(made.automaton, vocabulary_, reads_);
      for (const ltl::Lasso& word : words_)
        ASSERT_EQ(accepts(before, word), accepts(after, word))
            << which << ", limit " << limit << " of " << needed << ", word " << ltl::show(word, vocabulary_);
    }
  }
  Automaton drawn(ltl::Random& random, std::uint32_t states, std::uint32_t sets) const {
    return random_automaton(random, vocabulary_,
                            {.states = states, .sets = sets, .branches = 2, .empty = 0.3, .generic = false});
  }
};

TEST_F(CutShort, ReduceSaysSo) {
  ltl::Random random(seed);
  for (std::size_t i = 0; i < (testing::sanitized ? 4U : 25U); ++i) {
    const TransitionRelation given =
        drawn(random, static_cast<std::uint32_t>(2 + i % 6), static_cast<std::uint32_t>(i % 3)).transitions();
    const std::string which = "seed " + std::to_string(seed) + ", automaton " + std::to_string(i);
    is_told(
        given, [&](Budget& budget) { return reduce(given, MarksOn::Edges, budget); }, which, 12);
  }
  EXPECT_GT(steps_, some_steps);
}

// Large enough for both ways of reduce_as_marked, on some of them.
TEST_F(CutShort, ReduceAsMarkedSaysSo) {
  ltl::Random random(seed + 1);
  for (std::size_t i = 0; i < (testing::sanitized ? 4U : 40U); ++i) {
    const TransitionRelation given =
        drawn(random, static_cast<std::uint32_t>(4 + i % 9), static_cast<std::uint32_t>(1 + i % 3)).transitions();
    const std::string which = "seed " + std::to_string(seed + 1) + ", automaton " + std::to_string(i);
    is_told(
        given, [&](Budget& budget) { return reduce_as_marked(given, budget); }, which, 12);
  }
  EXPECT_GT(steps_, some_steps);
}

TEST_F(CutShort, ReduceAsMarkedSaysSoOfFormulas) {
  for (const char* text :
       {"G((F b & (G !a R !a)) | (G !b & (F a U a)))", "G F a & G F b", "F G a | G F b",
        "(G F a -> G F b) & G(a -> F b)", "G(a | F(b & X a)) & G F !a", "F(a & X F b) | G F(a & X !b)"}) {
    ltl::Arena arena(vocabulary_);
    Budget any;
    const TransitionRelation given = tableau(ltl::nnf(ltl::parse(text, arena)), reads_, any).automaton;
    is_told(
        given, [&](Budget& budget) { return reduce_as_marked(given, budget); }, text, testing::sanitized ? 4 : 30);
  }
  EXPECT_GT(steps_, some_steps);
}

TEST_F(CutShort, StateMergingSaysSo) {
  for (const char* text : {"F G a | G F b", "F G(a & X b) | G F a", "a | G F b", "F G a | G F(a & X b)"}) {
    ltl::Arena arena(vocabulary_);
    const ltl::Formula f = ltl::parse(text, arena);
    const auto general = [&](ltl::Formula g) {
      Budget any;
      return reduce(tableau(ltl::nnf(g), reads_, any).automaton, MarksOn::Edges, any).automaton;
    };
    Budget any;
    const TransitionRelation inside = general(f), outside = general(negate(f));
    const TransitionRelation on_states = degeneralize(inside, {}, any);
    is_told(
        inside, [&](Budget& budget) { return state_merged(inside, outside, MarksOn::Edges, budget); }, text, 30);
    is_told(
        on_states, [&](Budget& budget) { return state_merged(on_states, outside, MarksOn::States, budget); }, text, 30);
  }
  EXPECT_GT(steps_, some_steps / 5);
}

}  // namespace
}  // namespace waymark::automata
