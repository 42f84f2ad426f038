// Formulas of one shape have one automaton, to the byte, when its propositions are renamed: what a batch relies on.
#include "libltl/structure/shape.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/letters.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

// a, b, c as names that sort the other way round, and are longer.
std::string renamed(const std::string& text) {
  return testing::with_letters(text, [](char c) {
    return std::string(c == 'a' ? "window" : c == 'b' ? "lamp" : "chair");
  });
}

template <class Any>
std::string written(const Any& automaton) {
  return write_hoa(automaton);
}
std::string written(const MdpSafe& ldba) { return write_hoa(ldba.automaton()); }

template <class Translate>
void expect_one_automaton(const Translate& translate, std::uint64_t seed) {
  ltl::Random random(seed);
  ltl::Arena drawn(testing::letters_vocabulary(3));
  for (int i = 0; i < testing::scaled(300); ++i) {
    const std::string text = ltl::print(ltl::random_formula(random, drawn, {.size = 9}));
    ltl::Arena one, other;
    const Formula f = ltl::parse(text, one), g = ltl::parse(renamed(text), other);
    ASSERT_EQ(ltl::shape(f), ltl::shape(g)) << text;
    auto of_f = translate(f), of_g = translate(g);
    of_f.rename(other.vocabulary());
    ASSERT_EQ(written(of_f), written(of_g)) << text;
  }
}

TEST(Shape, GivesTheDfa) {
  expect_one_automaton([](Formula f) { return ltlf_to_dfa(f); }, 1);
}
TEST(Shape, GivesTheGeneralisedBuchiAutomaton) {
  expect_one_automaton([](Formula f) { return ltl_to_tgba(f); }, 2);
}
TEST(Shape, GivesTheBuchiAutomaton) {
  expect_one_automaton([](Formula f) { return ltl_to_buchi(f); }, 3);
}
TEST(Shape, GivesTheLimitDeterministicAutomaton) {
  expect_one_automaton([](Formula f) { return ltl_to_ldba(f); }, 4);
}

TEST(Shape, OnlyNamesForWhatIsRead) {
  ltl::Arena arena;
  Automaton automaton = ltl_to_tgba(ltl::parse("a U b", arena));
  EXPECT_THROW(automaton.rename(ltl::Vocabulary({"a"})), std::invalid_argument);
  Dfa dfa = ltlf_to_dfa(ltl::parse("a U b", arena));
  EXPECT_THROW(dfa.rename(ltl::Vocabulary({"a"})), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::automata
