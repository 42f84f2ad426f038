#include "libltl/structure/shape.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "libltl/structure/random.hpp"
#include "libltl/structure/shape_memo.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"
#include "tests/support/letters.hpp"

namespace waymark::ltl {
namespace {

std::string shape_of(const std::string& text) {
  Arena arena;
  return shape(parse(text, arena));
}

TEST(Shape, ForgetsNamesAndNothingElse) {
  EXPECT_EQ(shape_of("G(a -> F b)"), shape_of("G (lamp -> F sofa)"));
  EXPECT_EQ(shape_of("a U b"), shape_of("b U a"));
  EXPECT_NE(shape_of("a U b"), shape_of("a U a"));
  EXPECT_NE(shape_of("a U b"), shape_of("a R b"));
  EXPECT_NE(shape_of("F a & G b"), shape_of("G a & F b"));
  EXPECT_NE(shape_of("X a"), shape_of("N a"));
  Arena arena;  // one arena, two formulas
  const Formula f = parse("F a", arena), g = parse("G a", arena);
  EXPECT_NE(shape(f), shape(g));
}

// Numbers of more than seven bits: operands, propositions and the formula itself, one step apart or 128.
TEST(Shape, TellsLargeNumbersApart) {
  std::map<std::string, std::size_t> known;
  Arena arena;
  std::vector<Formula> atoms;
  for (std::size_t i = 0; i < 400; ++i) atoms.push_back(arena.atom("p" + std::to_string(i)));
  for (const Formula f : atoms) EXPECT_TRUE(known.emplace(shape(f), f.id()).second) << print(f);
  for (const std::size_t last : {1U, 127U, 128U, 129U, 255U, 256U, 257U, 384U}) {
    Arena other;
    for (std::size_t i = 0; i < 400; ++i) other.atom("q" + std::to_string(i));
    const Formula f = until(other.atom("q0"), other.atom("q" + std::to_string(last)));
    EXPECT_TRUE(known.emplace(shape(f), last).second) << last;
  }
}

// Each proposition as pᵢ, i its place in the vocabulary.
std::string anonymous(const std::string& text, const Vocabulary& vocabulary) {
  return testing::with_letters(text,
                               [&](char c) { return "p" + std::to_string(vocabulary.find(std::string(1, c))->index); });
}

TEST(Shape, IsThatOfTheTextWithOtherNames) {
  Random random(20261122);
  Arena drawn(testing::letters_vocabulary(3));
  std::map<std::string, std::string> text_of;  // by shape
  for (int i = 0; i < 2'000; ++i) {
    const std::string text = print(random_formula(random, drawn, {.size = 6}));
    Arena arena;
    const Formula f = parse(text, arena);
    EXPECT_EQ(shape(f), shape_of(anonymous(text, arena.vocabulary()))) << text;
    const std::string said = anonymous(print(f), arena.vocabulary());
    EXPECT_EQ(text_of.try_emplace(shape(f), said).first->second, said) << text;
  }
  EXPECT_GT(text_of.size(), 500U);
}

TEST(ShapeMemo, ComputesOnceAShapeWhatIsWorthKeeping) {
  ShapeMemo<std::size_t> memo(2);
  int computed = 0;
  const auto ask = [&](const std::string& text) {
    Arena arena;
    const auto size = [&](Formula f) {
      ++computed;
      return tree_size(f);
    };
    return memo(parse(text, arena), size, [](std::size_t n) { return n < 4; });
  };
  EXPECT_FALSE(ask("F a").known);
  EXPECT_TRUE(ask("F b").known);
  EXPECT_EQ(*ask("F c").result, 3U);
  EXPECT_EQ(computed, 1);
  EXPECT_FALSE(ask("a & F b").known);  // not worth it
  EXPECT_FALSE(ask("b & F a").known);
  EXPECT_EQ(computed, 3);
  EXPECT_FALSE(ask("G a").known);
  EXPECT_TRUE(ask("G b").known);
  EXPECT_FALSE(ask("X a").known);  // full
  EXPECT_FALSE(ask("X b").known);
}

}  // namespace
}  // namespace waymark::ltl
