#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "libltl/english/read_english.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::ltl {
namespace {

using testing::all_formulas;
using testing::all_lassos;
using testing::all_traces;
using testing::letters_vocabulary;
using testing::WordSpace;

struct Row {
  const char *formula, *english;
};

// Of a chair, a blue floor and two events; p and q are symbols.
VerbaliseOptions hallway(const Arena& arena) {
  return {.describe = [&arena](Proposition p) {
    const std::string& name = arena.vocabulary().name(p);
    if (name == "chair" || name == "sofa" || name == "lamp") return place("the " + name);
    if (name == "blue") return floor("the blue floor");
    if (name == "moved") return event("go forward");
    if (name == "left") return event("turn left");
    if (name == "right") return event("turn right");
    return symbol(name);
  }};
}

TEST(Verbalise, SaysWhatAFormulaMeans) {
  const Row table[] = {
      {"F(chair & F sofa) & G !blue", "go to the chair, then go to the sofa; never step on the blue floor."},
      {"G (p -> F q)", "whenever p holds, q holds later or at the same time."},
      {"G (p -> X (q U r))", "whenever p holds, one step later q holds until r holds."},
      {"(p U q) U (q U p)",
       "(A) holds until (B) holds. (A) means: p holds until q holds. (B) means: q holds until p holds."},
      {"X(left & X(moved & X(moved & F chair)))", "turn left, then go forward 2 times, then go to the chair."},
      {"(!sofa U chair) & F sofa", "do not go to the sofa until you are at the chair; go to the sofa."},
      {"(p & X(moved U (moved & chair))) | (!p & F sofa)",
       "if p holds, go forward until you are at the chair, otherwise go to the sofa."},
      {"G F p", "again and again p holds."},
      {"p M (!p | G (p | G !p))", "the number of stretches in which p holds is exactly 1."},
      {"F (p & (p U (!p & (!p U F p))))", "the number of stretches in which p holds is at least 2."},
      {"F chair | F sofa", "go to the chair or go to the sofa."},
      {"G (p <-> X q)", "always p holds exactly when one step later q holds."},
      {"F(p & q | r)", "eventually p holds and q holds, or r holds."},
      {"!p U (p U (!p U q))", "before q holds, which happens, p holds in at most one stretch."},
      {"F<=3 chair", "within 3 steps you are at the chair."},
      {"p ^ X q", "p holds exactly when it is not so that one step later q holds."},
      {"X X p", "2 steps later p holds."},
  };
  for (const Row& row : table) {
    Arena arena;
    const Formula f = parse(row.formula, arena);
    EXPECT_EQ(verbalise(f, hallway(arena)), row.english) << row.formula;
  }
}

// Equal by pointer, or on all short words: `to` holds both.
bool same(Formula f, Formula g, Semantics semantics) {
  if (f == g) return true;
  const WordSpace words{.length = 4, .atoms = f.arena().vocabulary().size()};
  if (semantics == Semantics::Finite) {
    for (const Trace& word : all_traces(words))
      if (holds(word, f) != holds(word, g)) return false;
  } else {
    for (const Lasso& word : all_lassos(words))
      if (holds(word, f) != holds(word, g)) return false;
  }
  return true;
}

void expect_read_back(Formula f, const VerbaliseOptions& options) {
  const std::string text = verbalise(f, options);
  const auto back = read_english(text, f.arena(), options);
  ASSERT_TRUE(back) << print(f) << "   " << text;
  EXPECT_TRUE(same(f, *back, options.semantics)) << print(f) << "   " << text << "   " << print(*back);
}

// Of the two propositions, one is a place and the other an event, or both are symbols.
std::vector<VerbaliseOptions> descriptions() {
  const auto robot = [](Proposition p) { return p.index == 0 ? floor("the blue floor") : event("turn left"); };
  return {{.semantics = Semantics::Finite},
          {.semantics = Semantics::Infinite},
          {.semantics = Semantics::Finite, .describe = robot},
          {.semantics = Semantics::Infinite, .describe = robot}};
}

TEST(ReadEnglishText, ReadsBackAllSmallFormulas) {
  for (const VerbaliseOptions& options : descriptions()) {
    Arena arena(letters_vocabulary(2));
    for (Formula f : all_formulas(arena, {.size = 4, .atoms = 2}))
      ASSERT_NO_FATAL_FAILURE(expect_read_back(f, options));
  }
}

class ReadEnglish : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ReadEnglish, ReadsBackRandomFormulas) {
  const VerbaliseOptions options = descriptions()[GetParam()];
  Random random(14);
  Arena arena(letters_vocabulary(2));
  for (int i = 0; i < testing::scaled(5'000); ++i)
    ASSERT_NO_FATAL_FAILURE(
        expect_read_back(random_formula(random, arena, {.size = 1 + random.below(9), .atoms = 2}), options));
}
INSTANTIATE_TEST_SUITE_P(Descriptions, ReadEnglish, ::testing::Range<std::size_t>(0, descriptions().size()));

// Names that are written in quotes, with the words of phrases in them, a quote, and a backslash.
TEST(ReadEnglishText, WordsOfPhrasesStandInQuotes) {
  for (const Semantics semantics : {Semantics::Finite, Semantics::Infinite}) {
    const VerbaliseOptions options{.semantics = semantics};
    Arena arena(Vocabulary({"a until b, then c", R"(say "or, then" \ and)"}));
    for (Formula f : all_formulas(arena, {.size = 3, .atoms = 2}))
      ASSERT_NO_FATAL_FAILURE(expect_read_back(f, options));
    Random random(15);
    for (int i = 0; i < testing::scaled(300); ++i)
      ASSERT_NO_FATAL_FAILURE(
          expect_read_back(random_formula(random, arena, {.size = 1 + random.below(9), .atoms = 2}), options));
  }
}

// The lifted templates of the literature, where they are at hand.
TEST(ReadEnglishText, StretchesAreCounted) {
  const auto word = [](std::size_t stretches) {
    std::vector<Letter> letters{{}};
    for (std::size_t i = 0; i < stretches; ++i)
      letters.insert(letters.end(), {Letter{Proposition{0}}, Letter{Proposition{0}}, Letter{}});
    return Lasso(letters, {Letter{}});
  };
  for (const std::string how : {"exactly", "at least", "at most"})
    for (std::size_t n = 1; n <= 4; ++n) {
      Arena arena(letters_vocabulary(1));
      const std::string text = "the number of stretches in which a holds is " + how + ' ' + std::to_string(n) + '.';
      const auto f = read_english(text, arena);
      ASSERT_TRUE(f) << text;
      for (std::size_t there = 0; there <= 5; ++there)
        EXPECT_EQ(holds(word(there), *f), there == n || how == (there > n ? "at least" : "at most"))
            << text << ' ' << there;
    }
}

// After (Z) comes (A1).
TEST(Verbalise, LettersDoNotRunOut) {
  std::string text = "p0 U q0";
  for (int i = 1; i < 30; ++i) text = "(" + text + ") U (p" + std::to_string(i) + " U q" + std::to_string(i) + ")";
  Arena arena;
  const Formula f = parse(text, arena);
  const std::string english = verbalise(f);
  EXPECT_NE(english.find(". (Z) means: "), std::string::npos) << english;
  EXPECT_NE(english.find(". (A1) means: "), std::string::npos) << english;
  EXPECT_EQ(read_english(english, arena), f);
}

TEST(ReadEnglishText, ReadsBackTemplates) {
  const char* const given = std::getenv("WAYMARK_SHARED");
  std::ifstream in(std::string(given != nullptr ? given : WAYMARK_SOURCE_DIR "/../shared") + "/commands/templates.tsv");
  if (!in) GTEST_SKIP() << "SKIPPED: no templates";
  std::string line;
  std::getline(in, line);
  std::size_t count = 0;
  for (; std::getline(in, line); ++count) {
    Arena arena;
    const Formula f = parse(line.substr(line.rfind('\t') + 1), arena);
    for (const VerbaliseOptions& options : {VerbaliseOptions{}, VerbaliseOptions{.describe = [&](Proposition p) {
                                              return place(arena.vocabulary().name(p));
                                            }}}) {
      const std::string text = verbalise(f, options);
      EXPECT_EQ(read_english(text, arena, options), f) << line << "   " << text;
    }
  }
  EXPECT_GT(count, 0U);
}

TEST(ReadEnglishText, RefusesWhatVerbaliseDoesNotWrite) {
  Arena arena(letters_vocabulary(2));
  for (const char* text : {"", ".", "a", "a holds", "c holds.", "a holds b holds.", "eventually.", "(A) holds.",
                           "(A) holds. (A) means: (A) holds.", "a holds and b holds or a holds.",
                           "0 steps later a holds.", "please, a holds.", "xyzzy plugh."})
    EXPECT_FALSE(read_english(text, arena)) << text;
}

// A place that nobody described is no place, alone or beside one that is known.
TEST(ReadEnglishText, RefusesWhatItHasNoWordFor) {
  const VerbaliseOptions options = descriptions()[2];
  Arena arena(letters_vocabulary(2));
  const std::string known = "the blue floor", unknown = "the red floor";
  int refused = 0;
  for (Formula f : all_formulas(arena, {.size = 4, .atoms = 2})) {
    const std::string text = verbalise(f, options);
    for (std::size_t at = text.find(known); at != std::string::npos; at = text.find(known, at + 1)) {
      for (const std::string& other : {unknown, known + " or " + unknown, unknown + " or " + known}) {
        std::string changed = text;
        changed.replace(at, known.size(), other);
        EXPECT_FALSE(read_english(changed, arena, options)) << changed;
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace waymark::ltl
