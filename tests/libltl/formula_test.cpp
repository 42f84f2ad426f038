#include "libltl/formula.hpp"

#include <gtest/gtest.h>

namespace waymark::ltl {
namespace {

TEST(Formula, EqualStructureIsEqualPointer) {
  Arena arena;
  const Formula a = arena.atom("a"), b = arena.atom("b");
  EXPECT_EQ(until(a, b), until(arena.atom("a"), arena.atom("b")));
  EXPECT_EQ(conjunction(a, b), conjunction(b, a));
  EXPECT_EQ(conjunction(a, conjunction(b, a)), conjunction(a, b));
  EXPECT_EQ(negate(negate(a)), a);
}

TEST(Formula, ConstructorsFoldPropositionalIdentitiesOnly) {
  Arena arena;
  const Formula a = arena.atom("a"), yes = arena.constant(true), no = arena.constant(false);
  EXPECT_EQ(conjunction(a, negate(a)), no);
  EXPECT_EQ(disjunction(a, negate(a)), yes);
  EXPECT_EQ(conjunction(a, yes), a);
  EXPECT_EQ(iff(negate(a), a), no);
  EXPECT_EQ(iff(a, yes), a);
  EXPECT_EQ(iff(arena.atom("z"), a), iff(a, arena.atom("z")));
  // On a suffix, F true says "more to come" and G false "at the end": neither may be folded.
  EXPECT_NE(eventually(yes), yes);
  EXPECT_NE(always(no), no);
  EXPECT_NE(next(yes), yes);
  EXPECT_NE(next(no), no);
}

TEST(Formula, TransferKeepsStructure) {
  Arena from, to;
  to.atom("b");
  const Formula f = until(iff(from.atom("a"), next(from.atom("b"))), negate(from.atom("c")));
  EXPECT_EQ(transfer(transfer(f, to), from), f);
}

}  // namespace
}  // namespace waymark::ltl
