#include "libltl/rewriting/implication.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "libltl/text/parse.hpp"

namespace waymark::ltl {
namespace {

bool implies(const char* from, const char* to) {
  Arena arena;
  const Formula f = parse(from, arena);
  return Implication()(f, parse(to, arena));
}

// At least one row for each rule, where no other rule answers. That no rule says too much is a law of simplify_test.
TEST(Implication, IsSeenByEveryRule) {
  const struct {
    const char *from, *to;
  } table[] = {
      {"false", "a"},
      {"X a", "true"},
      {"X a", "X a"},
      // junctions
      {"X a", "X a & true"},
      {"X (a & b)", "X a & X b"},
      {"X a | X b", "X (a | b)"},
      {"X a", "b | X a"},
      {"X a & b", "X a"},
      // the same operator on both sides
      {"X a", "N a"},
      {"X (a & b)", "N a"},
      {"N (a & b)", "N a"},
      {"X (a & b)", "X b"},
      {"!X a", "!X (a & b)"},
      {"(a & b) U (c & d)", "a U c"},
      {"(a & b) R (c & d)", "a R c"},
      {"G (a & b)", "G a"},
      {"F (a & b)", "F a"},
      // expansions
      {"b & c", "a U b"},
      {"a R (b & c)", "b"},
      {"X F a", "F a"},
      {"X X F a", "F a"},
      {"G a", "N G a"},
      {"G a", "N N G a"},
      {"a & b & c", "a R b"},
      {"a U b", "a | b"},
      {"(a & c) U (b & c)", "c"},
  };
  for (const auto& row : table) EXPECT_TRUE(implies(row.from, row.to)) << row.from << " implies " << row.to;
}

TEST(Implication, IsNotSeenWhereThereIsNone) {
  const struct {
    const char *from, *to;
  } table[] = {
      {"a", "b"},     {"N a", "X a"},     {"X a", "X b"},         {"a U b", "a"},     {"a U b", "b"},
      {"a | b", "a"}, {"a R b", "a"},     {"!X (a & b)", "!X a"}, {"F a", "X F a"},   {"X (a U b)", "a U b"},
      {"b", "a R b"}, {"N G a", "G a"},   {"N F a", "F a"},       {"X G a", "G a"},   {"G F a", "F G a"},
      {"F a", "a"},   {"a U b", "c U b"}, {"a R b", "c R b"},     {"a U b", "a U c"}, {"G a", "X G a"},
  };
  for (const auto& row : table) EXPECT_FALSE(implies(row.from, row.to)) << row.from << " implies " << row.to;
}

TEST(Implication, AsksTheOracleLast) {
  Arena arena;
  std::size_t asked = 0;
  Implication implication([&](Formula, Formula) { return ++asked > 0; });
  EXPECT_TRUE(implication(parse("X (a & b)", arena), parse("X a", arena)));
  EXPECT_EQ(asked, 0U);
  EXPECT_TRUE(implication(parse("F a", arena), parse("G a", arena)));
  EXPECT_EQ(asked, 1U);
  EXPECT_FALSE(implication(parse("a", arena), parse("!a", arena))) << "literals are compared, no more";
  EXPECT_EQ(asked, 1U);
}

// Nested deeper than is looked into: no.
TEST(Implication, LooksSoDeep) {
  const auto nested = [](std::size_t depth, const char* inside) {
    std::string text = inside;
    for (std::size_t i = 0; i < depth; ++i) text = "X (" + text + ")";
    return text;
  };
  EXPECT_TRUE(
      implies(nested(Implication::most_depth - 2, "a & b").c_str(), nested(Implication::most_depth - 2, "a").c_str()));
  EXPECT_FALSE(
      implies(nested(Implication::most_depth + 1, "a & b").c_str(), nested(Implication::most_depth + 1, "a").c_str()));
}

}  // namespace
}  // namespace waymark::ltl
