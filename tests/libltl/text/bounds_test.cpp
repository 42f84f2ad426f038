// Bounded operators against the constructors that spell them out, and the implications of chains against ⊨.
#include "libltl/text/bounds.hpp"

#include <gtest/gtest.h>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

TEST(Bounds, AreFoundForEveryBodyAndBound) {
  Arena arena(testing::letters_vocabulary(2));
  Bounds bounds;
  std::size_t found = 0;
  for (const Formula body : testing::all_formulas(arena, {.size = 4, .atoms = 2})) {
    if (body.op() == Op::False || body.op() == Op::True) continue;  // folds
    if (bounds.of(body)) continue;                                  // a bound itself: F<=2 F<=3 φ has another spelling
    for (const std::size_t steps : {1, 2, 5}) {
      for (const Formula f : {eventually_within(steps, body), always_within(steps, body)}) {
        const std::optional<Bound> bound = bounds.of(f);
        if (!bound) continue;  // φ ∨ X φ with a φ that is a junction of its own next may fold
        ++found;
        const auto spelled = bound->junction == Op::Or ? eventually_within : always_within;
        EXPECT_EQ(spelled(bound->steps, bound->body), f) << testing::show(f);
      }
    }
  }
  EXPECT_GT(found, 1000U);
}

TEST(Bounds, ArePartsOfLargerJunctions) {
  Arena arena;
  Bounds bounds;
  const Formula f = parse("!p | F<=3 a", arena);
  EXPECT_FALSE(bounds.of(f));
  const std::optional<Bounds::Part> part = bounds.part(f.operands(), Op::Or);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->bound.steps, 3U);
  EXPECT_EQ(part->bound.body, parse("a", arena));
  EXPECT_EQ(part->rest, std::vector<Formula>{parse("!p", arena)});
}

TEST(Bounds, ImplyOnlyWhatHoldsOnAllWords) {
  Arena arena(testing::letters_vocabulary(2));
  Bounds bounds;
  std::vector<Formula> some;
  for (const char* body : {"a", "a & b", "a | X b", "a U b"})
    for (const char* bounded : {"F<=1", "F<=2", "F<=3", "G<=1", "G<=2", "G<=3"})
      some.push_back(parse(std::string(bounded) + "(" + body + ")", arena));
  std::size_t implications = 0;
  const std::vector<Trace> words = testing::all_traces({.length = 4, .atoms = 2});
  for (const Formula f : some)
    for (const Formula g : some) {
      if (!bounds.implies(f, g)) continue;
      ++implications;
      for (const Trace& word : words)
        ASSERT_TRUE(!holds(word, f) || holds(word, g)) << testing::show(f) << " ⇒ " << testing::show(g, word);
    }
  EXPECT_GE(implications, 4U * 2U * 6U) << "six pairs a body and operator";
}

TEST(Bounds, OfAThousandStepsAreFoundOnce) {
  Arena arena;
  EXPECT_TRUE(has_bounds(parse("G(p -> F<=1000 q)", arena)));
  EXPECT_FALSE(has_bounds(parse("G(p -> X X X q) & F(p | X q)", arena)));
}

}  // namespace
}  // namespace waymark::ltl
