// Monitors of conjunctions against monitors of one automaton, which monitor_test.cpp compares with the definition.
#include "libautomata/monitor/conjunction.hpp"

#include <gtest/gtest.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

ConjunctionMonitor monitor(ltl::Formula f, Words words, const JointEffort& effort = {}) {
  return std::get<ConjunctionMonitor>(ConjunctionMonitor::of(f, words, {}, effort));
}

// What the two automata of φ and ¬φ say, over infinite words and over finite ones.
std::vector<Foresight> expected_infinite(ltl::Formula f, const ltl::Trace& word) {
  const Monitor m = std::get<Monitor>(ltl_to_monitor(f, {}));
  std::vector<Foresight> out;
  Monitor::State q = m.initial();
  for (const ltl::Letter& letter : word) out.push_back(m.verdict(q = m.next(q, letter)));
  return out;
}
std::vector<MonitorVerdict> expected_finite(ltl::Formula f, const ltl::Trace& word) {
  const Dfa yes = ltlf_to_dfa(f), no = ltlf_to_dfa(ltl::negate(f));
  std::vector<MonitorVerdict> out;
  StateId at_yes = yes.initial(), at_no = no.initial();
  for (const ltl::Letter& letter : word) {
    at_yes = yes.next(at_yes, letter);
    at_no = no.next(at_no, letter);
    const Foresight foresight = yes.is_trap(at_yes) ? Foresight::False
                                : no.is_trap(at_no) ? Foresight::True
                                                    : Foresight::Open;
    out.push_back({foresight, yes.is_accepting(at_yes), true});
  }
  return out;
}

void compare(ltl::Formula f, const std::vector<ltl::Trace>& words, const std::string& origin) {
  const Monitor m = std::get<Monitor>(ltl_to_monitor(f, {}));
  for (const ltl::Trace& word : words) {
    ConjunctionMonitor infinite = monitor(f, Words::Infinite), finite = monitor(f, Words::Finite);
    const std::vector<Foresight> in_infinite = expected_infinite(f, word);
    const std::vector<MonitorVerdict> in_finite = expected_finite(f, word);
    for (std::size_t i = 0; i < word.size(); ++i) {
      const MonitorVerdict said = infinite.read(word[i]);
      ASSERT_EQ(said.foresight, in_infinite[i]) << testing::show(f, word) << " letter " << i << origin;
      ASSERT_TRUE(said.is_known_satisfiable);
      ASSERT_EQ(finite.read(word[i]), in_finite[i]) << testing::show(f, word) << " finite, letter " << i << origin;
    }
  }
}

TEST(ConjunctionMonitor, SaysWhatOneAutomatonSays) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  const std::vector<ltl::Trace> words = testing::all_traces({.length = 2, .atoms = 2});
  std::vector<ltl::Formula> some;
  for (const char* text : {"a", "G a", "F a", "F !a", "X b", "N b", "G(a -> X b)", "a U b", "a W b", "G F a", "F G !a",
                           "F(a & X b)", "G !b", "N false", "X X true", "N N false", "X a <-> F b"})
    some.push_back(ltl::parse(text, arena));
  for (const ltl::Formula f : some)
    for (const ltl::Formula g : some) {
      compare(ltl::conjunction(f, g), words, "");
      compare(ltl::disjunction(f, g), words, "");
    }
}

TEST(ConjunctionMonitor, SaysWhatOneAutomatonSaysOfRandomConjunctions) {
  ltl::Random random(5);
  for (int i = 0; i < 60; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const std::vector<ltl::Formula> all = testing::all_formulas(arena, {.size = 4, .atoms = 3});
    std::vector<ltl::Formula> parts;
    for (int j = 0; j < 4; ++j) parts.push_back(all[random.below(all.size())]);
    std::vector<ltl::Trace> words;
    for (int j = 0; j < 5; ++j) {
      std::vector<ltl::Letter> letters(4);
      for (ltl::Letter& letter : letters)
        for (std::uint32_t p = 0; p < 3; ++p)
          if (random.below(2) == 0) letter.insert({p});
      words.emplace_back(letters);
    }
    compare(ltl::conjunction(arena, parts), words, ", seed 5, formula " + std::to_string(i));
  }
}

TEST(ConjunctionMonitor, KnowsThatOpenConjunctsExcludeEachOther) {
  ltl::Arena arena;
  ConjunctionMonitor apart = monitor(ltl::parse("G(a -> F b) & G(a -> G !b) & F c", arena), Words::Infinite);
  EXPECT_EQ(apart.parts(), 3U);
  EXPECT_EQ(apart.read({}).foresight, Foresight::Open);
  EXPECT_EQ(apart.read({arena.add_proposition("a")}).foresight, Foresight::False);
  EXPECT_EQ(apart.read({arena.add_proposition("b")}).foresight, Foresight::False) << "for good";
  ConjunctionMonitor lengths = monitor(ltl::parse("X N false & X X N false & F a", arena), Words::Finite);
  EXPECT_EQ(lengths.read({}).foresight, Foresight::False) << "two letters, and three";
}

TEST(ConjunctionMonitor, SaysWhatItDoesNotKnow) {
  ltl::Arena arena;
  const char* text = "G(a -> F b) & G(a -> G !b)";
  ConjunctionMonitor lazy = monitor(ltl::parse(text, arena), Words::Infinite, {.question = 1, .all = 1});
  const MonitorVerdict said = lazy.read({arena.add_proposition("a")});
  EXPECT_EQ(said.foresight, Foresight::Open);
  EXPECT_FALSE(said.is_known_satisfiable);
}

// One automaton would have 2²⁰⁰ states.
TEST(ConjunctionMonitor, OfManyConjunctsAnswersEachLetter) {
  ltl::Arena arena;
  std::string text = "G(a -> F b0)";
  for (int i = 1; i < 200; ++i) text += " & G(a -> F b" + std::to_string(i) + ")";
  const ltl::Formula f = ltl::parse(text, arena);
  for (const Words words : {Words::Infinite, Words::Finite}) {
    ConjunctionMonitor m = monitor(f, words);
    EXPECT_EQ(m.parts(), 200U);
    ltl::Random random(7);
    for (int i = 0; i < 300; ++i) {
      ltl::Letter letter;
      for (std::uint32_t p = 0; p < 201; ++p)
        if (random.below(3) == 0) letter.insert({p});
      const MonitorVerdict said = m.read(letter);
      ASSERT_EQ(said.foresight, Foresight::Open);
      ASSERT_TRUE(said.is_known_satisfiable);
    }
  }
}

}  // namespace
}  // namespace waymark::automata
