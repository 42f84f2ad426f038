#include "libltl/structure/fragment.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/rewriting/nnf.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

// p propositional, n next-free, s safety, c co-safety, o obligation, r recurrence, e persistence
std::string letters(const Fragments& f) {
  std::string out;
  if (f.propositional) out += 'p';
  if (f.next_free) out += 'n';
  if (f.safety) out += 's';
  if (f.cosafety) out += 'c';
  if (f.obligation) out += 'o';
  if (f.recurrence) out += 'r';
  if (f.persistence) out += 'e';
  return out;
}

TEST(Fragments, AreReadOffTheSyntax) {
  const struct {
    const char *formula, *infinite, *finite;
  } table[] = {
      {"a & !b", "pnscore", "pnsc"}, {"X a", "score", "c"},          {"N a", "score", "s"},
      {"!X a", "score", "s"},        {"F a", "ncore", "nc"},         {"G a", "nsore", "ns"},
      {"!F a", "nsore", "ns"},       {"a U b", "ncore", "nc"},       {"a W b", "nsore", "ns"},
      {"a M b", "ncore", "nc"},      {"G a | F b", "nore", "n"},     {"G F a", "nr", "n"},
      {"F G a", "ne", "n"},          {"G F a | F G b", "n", "n"},    {"G(a -> F b)", "nr", "n"},
      {"a <-> F b", "nore", "n"},    {"a <-> X b", "score", ""},     {"G a U b", "nore", "n"},
      {"a W F b", "nore", "n"},      {"(F a) M (G b)", "nore", "n"}, {"F<=2 a", "score", "c"},
      {"Y a", "score", "sc"},        {"a S b", "nscore", "nsc"},     {"O a", "nscore", "nsc"},
      {"a W G F b", "nr", "n"},      {"a W F G b", "ne", "n"},       {"F a W F G b", "n", "n"},
      {"F a W b", "nr", "n"},        {"F G a W b", "n", "n"},        {"G a M F b", "ne", "n"},
      {"F Y a", "core", "c"},        {"G(a S b)", "nsore", "ns"},    {"Y F a", "core", "c"},
      {"F a S b", "ncore", "nc"},    {"a S G b", "nsore", "ns"},     {"F a S G b", "nore", "n"},
      {"Y G F a", "r", ""},          {"a S F G b", "ne", "n"},       {"O (a & X b)", "score", "c"},
      {"!(a S F b)", "nsore", "ns"}, {"Y a S b", "score", "sc"},
  };
  for (const auto& row : table) {
    Arena arena;
    const Formula f = parse(row.formula, arena);
    EXPECT_EQ(letters(fragments(f, Semantics::Infinite)), row.infinite) << row.formula;
    EXPECT_EQ(letters(fragments(f, Semantics::Finite)), row.finite) << row.formula;
  }
}

TEST(Laws, SafetyIsClosedUnderPrefixesAndCosafetyUnderExtensions) {
  Arena arena(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 4, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2, .past = true}, [&](Formula f) {
    const Fragments in = fragments(f, Semantics::Finite);
    if (!in.safety && !in.cosafety) return;
    for (const Trace& word : words) {
      if (word.size() < 2) continue;
      const Trace prefix(std::vector<Letter>(word.begin(), word.end() - 1));
      const bool shorter = holds(prefix, f), longer = holds(word, f);
      ASSERT_TRUE(!in.safety || longer <= shorter) << show(f, word);
      ASSERT_TRUE(!in.cosafety || shorter <= longer) << show(f, word);
    }
  });
}

// u·v·v·…, `length` letters.
Trace unroll(const Lasso& word, std::size_t length) {
  std::vector<Letter> letters;
  for (std::size_t i = 0; letters.size() < length; i = word.successor(i)) letters.push_back(word[i]);
  return Trace(std::move(letters));
}

// A co-safe formula holds on an infinite word iff it holds, every next read as strong, on some finite prefix; the
// formulas and lassos here are so small that twelve letters decide. Safety is the dual.
TEST(Laws, CosafetyIsDecidedByAFinitePrefix) {
  Arena arena(testing::letters_vocabulary(2));
  const auto lassos = testing::all_lassos({.length = 2, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2}, [&](Formula f) {
    const Fragments in = fragments(f, Semantics::Infinite);
    if (in.cosafety == in.safety) return;  // neither, or so bounded that both hold
    const Formula g = nnf(in.cosafety ? f : negate(f));
    if (!fragments(g, Semantics::Finite).cosafety) return;  // an N: not literally the same formula
    for (const Lasso& word : lassos) ASSERT_EQ(holds(word, g), holds(unroll(word, 12), g)) << show(g, word);
  });
}

TEST(Laws, NextFreeFormulasDoNotNoticeStuttering) {
  Arena arena(testing::letters_vocabulary(2));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  testing::for_each_formula(arena, {.size = 4, .atoms = 2, .past = true}, [&](Formula f) {
    if (!fragments(f, Semantics::Finite).next_free) return;
    for (const Trace& word : words)
      for (std::size_t i = 0; i < word.size(); ++i) {
        std::vector<Letter> letters(word.begin(), word.end());
        letters.insert(letters.begin() + static_cast<std::ptrdiff_t>(i), word[i]);
        const Trace longer(std::move(letters));
        ASSERT_EQ(holds(word, f), holds(longer, f)) << show(f, longer);
      }
  });
}

}  // namespace
}  // namespace waymark::ltl
