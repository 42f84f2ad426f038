#include <gtest/gtest.h>

#include "libltl/english/read_english.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

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
      {"F(chair & F sofa) & G !blue", ""},
      {"G (p -> F q)", ""},
      {"G (p -> X (q U r))", ""},
      {"(p U q) U (q U p)", ""},
      {"X(left & X(moved & X(moved & F chair)))", ""},
      {"(!sofa U chair) & F sofa", ""},
      {"(p & X(moved U (moved & chair))) | (!p & F sofa)", ""},
      {"G F p", ""},
      {"p M (!p | G (p | G !p))", ""},
      {"F (p & (p U (!p & (!p U F p))))", ""},
      {"F chair | F sofa", ""},
      {"G (p <-> X q)", ""},
      {"F(p & q | r)", ""},
      {"!p U (p U (!p U q))", ""},
      {"F<=3 chair", ""},
      {"F chair | X (left|right) U ((left|right) & F chair)", ""},
      {"p ^ X q", ""},
  };
  for (const Row& row : table) {
    Arena arena;
    const Formula f = parse(row.formula, arena);
    const std::string text = verbalise(f, hallway(arena));
    const auto back = read_english(text, arena, hallway(arena));
    std::cout << row.formula << "   " << text << "  " << (back ? print(*back) : "?") << '\n';
  }
}

// Equal by pointer, or on all short words: `to` holds both.
bool same(Formula f, Formula g, Semantics semantics) {
  if (f == g) return true;
  const WordSpace words{.length = 5, .atoms = f.arena().vocabulary().size()};
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

TEST(ReadEnglish, ReadsBackAllSmallFormulas) {
  for (const VerbaliseOptions& options : descriptions()) {
    Arena arena(letters_vocabulary(2));
    for (Formula f : all_formulas(arena, {.size = 4, .atoms = 2})) ASSERT_NO_FATAL_FAILURE(expect_read_back(f, options));
  }
}

TEST(ReadEnglish, ReadsBackRandomFormulas) {
  for (const VerbaliseOptions& options : descriptions()) {
    Random random(14);
    Arena arena(letters_vocabulary(2));
    for (int i = 0; i < 5'000; ++i)
      ASSERT_NO_FATAL_FAILURE(expect_read_back(random_formula(random, arena, {.size = 1 + random.below(9), .atoms = 2}), options));
  }
}

TEST(ReadEnglish, RefusesWhatVerbaliseDoesNotWrite) {
  Arena arena(letters_vocabulary(2));
  for (const char* text : {"", ".", "a", "a holds", "c holds.", "a holds b holds.", "eventually.", "(A) holds.",
                           "(A) holds. (A) means: (A) holds.", "a holds and b holds or a holds.",
                           "0 steps later a holds.", "please, a holds.", "xyzzy plugh."})
    EXPECT_FALSE(read_english(text, arena)) << text;
}

}  // namespace
}  // namespace waymark::ltl
