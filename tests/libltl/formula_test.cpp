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

// Constants are folded where every semantics folds them, each operand by itself.
TEST(Formula, PastOperatorsFoldConstants) {
  Arena arena;
  const Formula a = arena.atom("a"), no = arena.constant(false), yes = arena.constant(true);
  EXPECT_EQ(yesterday(no), no);
  EXPECT_NE(yesterday(yes), yes) << "there is no yesterday at the first position";
  for (const Formula right : {a, no, yes}) EXPECT_EQ(since(no, right), right) << "false S φ = φ";
  for (const Formula left : {a, no, yes}) {
    EXPECT_EQ(since(left, no), no);
    EXPECT_EQ(since(left, yes), yes);
  }
  EXPECT_EQ(since(yes, a).op(), Op::Since);
}

TEST(Formula, TransferKeepsStructure) {
  Arena from, to;
  to.atom("b");
  const Formula f = until(iff(from.atom("a"), next(from.atom("b"))), negate(from.atom("c")));
  EXPECT_EQ(transfer(transfer(f, to), from), f);
}

}  // namespace
}  // namespace waymark::ltl
