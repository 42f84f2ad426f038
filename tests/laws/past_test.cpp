// Past operators: their laws on all small words, and every engine against the definition, future and past mixed.
#include <gtest/gtest.h>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/monitor/monitor.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/english/read_english.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libautomata/omega/referee.hpp"
#include "tests/support/generate.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using testing::show;

struct Law {
  const char *left, *right;
};

// Of words read from their first letter; those under G of every position.
constexpr Law laws[] = {
    {"G (O a)", "G (true S a)"},
    {"G (H a)", "G !O !a"},
    {"G (a S b)", "G (b | (a & Y(a S b)))"},
    {"G (a T b)", "G (b & (a | Z(a T b)))"},
    {"G (a T b)", "G !(!a S !b)"},
    {"G (Z a)", "G !Y !a"},
    {"G ((Y a) & (Y b))", "G (Y(a & b))"},
    {"G (H a -> b)", "!a R (!a | b)"},
    {"G (Y X a -> a)", "true"},
    {"G (a -> N Y a)", "true"},
    {"Y a", "false"},
    {"Z a", "true"},
    {"a S b", "b"},
    {"a T b", "b"},
    {"O a", "a"},
    {"F (b & O a)", "F (a & F b)"},
    {"F (b & H a)", "a U (a & b)"},
    {"G (b -> O a)", "!b W a"},
    {"F (b & Y a)", "F (a & X b)"},
    {"F (b & (c S a))", "F (a & (b | X (c U (c & b))))"},
    {"G F (Y a)", "G F (Y a & true)"},
    {"F (b & Z false)", "b"},
    {"F (b & Y !O a)", "!a U (!a & X b)"},
    {"H F a", "F a"},
};

template <class Words>
void laws_hold(const Words& words) {
  for (const Law& law : laws) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula left = ltl::parse(law.left, arena), right = ltl::parse(law.right, arena);
    for (const auto& word : words)
      ASSERT_EQ(ltl::holds(word, left), ltl::holds(word, right)) << law.right << " is not " << show(left, word);
  }
}

TEST(Past, LawsOnAllSmallFiniteWords) { laws_hold(testing::all_traces({.length = 4, .atoms = 3})); }
TEST(Past, LawsOnAllSmallLassos) { laws_hold(testing::all_lassos({.length = 3, .atoms = 3})); }

TEST(Past, IsReadFromTheFirstLetterOn) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  const ltl::Letter a{{0}}, none{};
  const ltl::Trace word({a, none, none});
  const auto row = [&](const char* text) { return ltl::truth(word, ltl::parse(text, arena)); };
  using Row = std::vector<bool>;
  EXPECT_EQ(row("Y a"), (Row{false, true, false}));
  EXPECT_EQ(row("Z a"), (Row{true, true, false}));
  EXPECT_EQ(row("O a"), (Row{true, true, true}));
  EXPECT_EQ(row("H a"), (Row{true, false, false}));
  EXPECT_EQ(row("!a S a"), (Row{true, true, true}));
  EXPECT_EQ(row("a T !b"), (Row{true, true, true}));
}

// u·vʷ is one word, however often its cycle is written out.
TEST(Past, MeansTheSameHoweverALassoIsWritten) {
  constexpr std::uint64_t seed = 11;
  ltl::Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const Formula f = ltl::random_formula(random, arena, {.size = 12, .atoms = 2, .past = true});
    std::vector<ltl::Letter> u, v;
    for (std::size_t n = random.below(3); n > 0; --n) u.push_back(ltl::random_letter(random, {.atoms = 2}));
    for (std::size_t n = 1 + random.below(3); n > 0; --n) v.push_back(ltl::random_letter(random, {.atoms = 2}));
    const ltl::Lasso word(u, v);
    const bool truth = ltl::holds(word, f);
    u.insert(u.end(), v.begin(), v.end());
    u.push_back(v.front());
    v.push_back(v.front());
    v.erase(v.begin());
    ASSERT_EQ(ltl::holds(ltl::Lasso(u, v), f), truth) << show(f, word) << ", seed " << seed;
  }
}

void finite_engines_agree(Formula f, std::span<const ltl::Trace> words) {
  const Dfa dfa = ltlf_to_dfa(f), shorter = ltlf_to_dfa(ltl::simplify(f, ltl::Over::Finite));
  EXPECT_EQ(dfa.vocabulary().size(), f.arena().vocabulary().size());
  for (const ltl::Trace& word : words) {
    const bool truth = ltl::holds(word, f);
    Formula rest = f;
    for (const ltl::Letter& letter : word) rest = ltl::simplify(ltl::progress(rest, letter), ltl::Over::Rest);
    ASSERT_EQ(ltl::accepts_empty(rest), truth) << "progression, " << show(f, word);
    ASSERT_EQ(accepts(dfa, word), truth) << "DFA, " << show(f, word);
    ASSERT_EQ(accepts(shorter, word), truth) << "DFA of the simplified formula, " << show(f, word);
    ASSERT_EQ(ltl::holds(word, ltl::nnf(f)), truth) << "normal form, " << show(f, word);
  }
}

TEST(Past, EnginesAgreeOnAllSmallFormulasAndFiniteWords) {
  ltl::Arena arena;
  const auto words = testing::all_traces({.length = 4, .atoms = 1});
  std::size_t formulas = 0;
  testing::for_each_formula(arena, {.size = 4, .atoms = 1, .past = true}, [&](Formula f) {
    if (!ltl::has_past(f)) return;
    ASSERT_NO_FATAL_FAILURE(finite_engines_agree(f, words));
    ++formulas;
  });
  EXPECT_GT(formulas, 100U);
}

TEST(Past, EnginesAgreeOnRandomFormulasAndFiniteWords) {
  constexpr std::uint64_t seed = 20261124;
  ltl::Random random(seed);
  for (int i = 0; i < 400; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 5 + random.below(8), .atoms = 3, .past = true});
    std::vector<ltl::Trace> words;
    for (int j = 0; j < 20; ++j)
      words.push_back(ltl::random_trace(random, {.length = 1 + random.below(8), .atoms = 3}));
    ASSERT_NO_FATAL_FAILURE(finite_engines_agree(f, words)) << "seed " << seed << ", formula " << i;
  }
}

void infinite_engines_agree(Formula f, std::span<const ltl::Lasso> words) {
  const Automaton tgba = ltl_to_tgba(f), buchi = ltl_to_buchi(f);
  const Automaton parity = ltl_to_dpa(f).automaton(), jumps = ltl_to_ldba(f).automaton();
  ASSERT_TRUE(is_deterministic(parity.transitions())) << show(f);
  const Formula simple = ltl::simplify(f, ltl::Over::Infinite);
  for (const ltl::Lasso& word : words) {
    const bool truth = ltl::holds(word, f);
    ASSERT_EQ(referee::accepts(tgba, word), truth) << "generalised Büchi, " << show(f, word);
    ASSERT_EQ(referee::accepts(buchi, word), truth) << "Büchi, " << show(f, word);
    ASSERT_EQ(referee::accepts(parity, word), truth) << "parity, " << show(f, word);
    ASSERT_EQ(referee::accepts(jumps, word), truth) << "limit-deterministic, " << show(f, word);
    ASSERT_EQ(ltl::holds(word, simple), truth) << "simplified to " << ltl::print(simple) << ", " << show(f, word);
  }
}

TEST(Past, EnginesAgreeOnAllSmallFormulasAndLassos) {
  ltl::Arena arena;
  const auto words = testing::all_lassos({.length = 4, .atoms = 1});
  testing::for_each_formula(arena, {.size = 4, .atoms = 1, .past = true}, [&](Formula f) {
    if (!ltl::has_past(f)) return;
    ASSERT_NO_FATAL_FAILURE(infinite_engines_agree(f, words));
  });
}

TEST(Past, EnginesAgreeOnRandomFormulasAndLassos) {
  constexpr std::uint64_t seed = 8;
  ltl::Random random(seed);
  for (int i = 0; i < 150; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(2));
    const Formula f = ltl::random_formula(random, arena, {.size = 4 + random.below(5), .atoms = 2, .past = true});
    std::vector<ltl::Lasso> words;
    for (int j = 0; j < 12; ++j)
      words.push_back(ltl::random_lasso(random, {.prefix = random.below(3), .cycle = 1 + random.below(3), .atoms = 2}));
    ASSERT_NO_FATAL_FAILURE(infinite_engines_agree(f, words)) << "seed " << seed << ", formula " << i;
  }
}

// A monitor's verdict is that of all continuations: here of the lassos that continue the prefix.
TEST(Past, MonitorsJudgePrefixes) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  const auto monitor = std::get<Monitor>(ltl_to_monitor(ltl::parse("G (b -> O a)", arena), {}));
  const ltl::Letter a{{0}}, b{{1}}, none{};
  EXPECT_EQ(monitor.verdict(monitor.next(monitor.initial(), none)), Foresight::Open);
  EXPECT_EQ(monitor.verdict(monitor.next(monitor.initial(), a)), Foresight::True);
  EXPECT_EQ(monitor.verdict(monitor.next(monitor.next(monitor.initial(), none), b)), Foresight::False);
}

TEST(Past, AutomataOfPurePastDoNotGrow) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  EXPECT_EQ(ltlf_to_dfa(ltl::parse("F (b & O a)", arena)).states(),
            ltlf_to_dfa(ltl::parse("F (a & F b)", arena)).states());
  EXPECT_EQ(ltl_to_dpa(ltl::parse("G (b -> O a)", arena)).automaton().states(),
            ltl_to_dpa(ltl::parse("!b W a", arena)).automaton().states());
}

TEST(Past, IsReadAsItIsPrinted) {
  constexpr std::uint64_t seed = 12;
  ltl::Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    ltl::Arena arena(testing::letters_vocabulary(3));
    const Formula f = ltl::random_formula(random, arena, {.size = 14, .atoms = 3, .past = true});
    for (const auto& [style, notation] :
         {std::pair{ltl::Style::Ascii, ltl::Notation::Infix}, std::pair{ltl::Style::Unicode, ltl::Notation::Infix},
          std::pair{ltl::Style::Lbt, ltl::Notation::Lbt}, std::pair{ltl::Style::Postfix, ltl::Notation::Postfix}})
      ASSERT_EQ(ltl::parse(ltl::print(f, style), arena, {.notation = notation}), f) << ltl::print(f, style);
    ASSERT_EQ(ltl::print(f, ltl::Style::Latex).find("history"), std::string::npos);
  }
}

TEST(Past, IsSaidInEnglish) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  for (const char* text : {"Y a", "Z a", "O a", "H a", "a S b", "a T b", "G (b -> O a)", "Y true", "!Y true"}) {
    const Formula f = ltl::parse(text, arena);
    const std::string english = ltl::verbalise(f);
    EXPECT_EQ(english.find("impossible"), std::string::npos) << text << ": " << english;
  }
}

TEST(Past, IsRefusedByName) {
  ltl::Arena arena(testing::letters_vocabulary(2));
  EXPECT_THROW(ltl::TraceCheck(ltl::parse("a S b", arena)), std::invalid_argument);
  // Spot's dialect has no past: these are names there.
  const Formula name = ltl::parse("F Y", arena, {.dialect = ltl::Dialect::Spot});
  EXPECT_EQ(ltl::print(name), "F \"Y\"");
}

}  // namespace
}  // namespace waymark::automata
