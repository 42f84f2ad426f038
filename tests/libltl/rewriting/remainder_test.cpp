#include "libltl/rewriting/remainder.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/meaning/progress.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace waymark::ltl {
namespace {

// Of many conjuncts and few: the word satisfies the formula exactly if it may end where the remainder is.
TEST(Remainder, AgreesWithTheDefinitionHoweverManyConjuncts) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    Arena arena(Vocabulary({"a", "b", "c"}));
    std::vector<Formula> parts;
    for (std::size_t n = 1 + random.below(14); n > 0; --n)
      parts.push_back(random_formula(random, arena, {.size = 6, .atoms = 3}));
    const Formula f = conjunction(arena, parts);
    Remainder remainder(f, Semantics::Finite);
    std::vector<Letter> letters;
    for (int length = 0; length < 4; ++length) {
      letters.push_back(random_letter(random, {.atoms = 3, .density = 0.6}));
      const Trace word(letters);
      ASSERT_EQ(accepts_empty(remainder.read(letters.back())), holds(word, f))
          << print(f) << " on " << show(word, arena.vocabulary());
    }
  }
}

TEST(Remainder, OfManyConjunctsIsTheirSum) {
  std::string text = "G !z";
  for (int i = 0; i < 200; ++i) text += " & G(a" + std::to_string(i) + " -> F b" + std::to_string(i) + ')';
  Arena arena;
  const Formula f = parse(text, arena);
  Remainder remainder(f, Semantics::Infinite);
  const auto letter = [&](const char* name) { return Letter({*arena.vocabulary().find(name)}); };
  for (int i = 0; i < 1'000; ++i) remainder.read(letter(i % 2 == 0 ? "a7" : "b7"));
  EXPECT_EQ(remainder.read(letter("b7")), f);
  EXPECT_EQ(remainder.read(letter("a3")), conjunction(f, parse("F b3", arena)));
  EXPECT_LT(arena.size(), 5'000U) << "nothing is made twice";
  EXPECT_EQ(remainder.read(letter("z")), arena.constant(false));
}

}  // namespace
}  // namespace waymark::ltl
