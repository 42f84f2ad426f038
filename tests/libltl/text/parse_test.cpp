#include "libltl/text/parse.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"

namespace waymark::ltl {
namespace {

struct Pair {
  const char *left, *right;
};

void expect_equal(const Pair& pair, const ParseOptions& options = {}) {
  Arena arena;
  const Formula left = parse(pair.left, arena, options), right = parse(pair.right, arena);
  EXPECT_EQ(left, right) << pair.left << " was read as " << print(left) << ", not " << print(right);
}

TEST(Parse, PrecedenceAndAssociativity) {
  const Pair table[] = {
      {"!a U b", "(!a) U b"},
      {"F a U b", "(F a) U b"},
      {"a U b & c", "(a U b) & c"},
      {"a & b | c", "(a & b) | c"},
      {"a | b ^ c", "(a | b) ^ c"},
      {"a ^ b -> c", "(a ^ b) -> c"},
      {"a -> b <-> c", "(a -> b) <-> c"},
      {"a -> b -> c", "a -> (b -> c)"},
      {"a U b U c", "a U (b U c)"},
      {"a U b R c W d M e", "a U (b R (c W (d M e)))"},
      {"G a -> F b", "(G a) -> (F b)"},
      {"X a & b", "(X a) & b"},
      {"a <-> b <-> c", "(a <-> b) <-> c"},
  };
  for (const Pair& pair : table) expect_equal(pair);
}

TEST(Parse, EverySpellingOfAnOperatorMeansTheSame) {
  const Pair table[] = {
      {"~a", "!a"},
      {"¬a", "!a"},
      {"a && b", "a & b"},
      {"a /\\ b", "a & b"},
      {"a ∧ b", "a & b"},
      {"a || b", "a | b"},
      {"a \\/ b", "a | b"},
      {"a ∨ b", "a | b"},
      {"a => b", "a -> b"},
      {"a → b", "a -> b"},
      {"a ⇒ b", "a -> b"},
      {"a <=> b", "a <-> b"},
      {"a ↔ b", "a <-> b"},
      {"a ⇔ b", "a <-> b"},
      {"a xor b", "a ^ b"},
      {"a ⊕ b", "a ^ b"},
      {"()a", "X a"},
      {"○a", "X a"},
      {"◯a", "X a"},
      {"X[!]a", "X a"},
      {"WX a", "N a"},
      {"X[w] a", "N a"},
      {"●a", "N a"},
      {"<>a", "F a"},
      {"◇a", "F a"},
      {"⬦a", "F a"},
      {"⟡a", "F a"},
      {"[]a", "G a"},
      {"□a", "G a"},
      {"[]<>a", "G F a"},
      {"a 𝒰 b", "a U b"},
      {"a V b", "a R b"},
      {"a ℛ b", "a R b"},
      {"a 𝒲 b", "a W b"},
      {"a ℳ b", "a M b"},
      {"1 & tt & ⊤", "true"},
      {"0 | ff | ⊥", "false"},
      {"F[<=2] a", "F<=2 a"},
      {"F[0:2]a", "F<=2 a"},
      {"◇≤2 a", "F<=2 a"},
      {"G [0:1] a", "G<=1 a"},
      {"GF a", "G F a"},
      {"XXNa & b", "XXNa & b"},
      {"XXN a", "X X N a"},
      {"XX[!]a", "X X a"},
      {"\"a\" U \"b\"", "a U b"},
  };
  for (const Pair& pair : table) expect_equal(pair);
}

TEST(Parse, BoundedOperatorsAreSpelledOut) {
  const Pair table[] = {
      {"F<=0 a", "a"},
      {"F<=2 a", "a | X(a | X a)"},
      {"a U<=2 b", "b | a & X(b | a & X b)"},
      {"a U[0:1] b U<=0 c", "a U<=1 c"},
      {"a U<=1 b & c", "(b | a & X b) & c"},
      {"G<=2 a", "a & N(a & N a)"},
      {"F[1:2] a", "X(a | X a)"},
      {"F[2,2] a", "X X a"},
      {"G[1, 2] a", "N(a & N a)"},
      {"F[2:] a", "X X F a"},
      {"G[1:] a", "N G a"},
      {"a U[1:2] b", "a & X(b | a & X b)"},
      {"a U[2:] b", "a & X(a & X(a U b))"},
      {"a U[0..1] b", "a U<=1 b"},
  };
  for (const Pair& pair : table) expect_equal(pair);
}

TEST(Parse, DialectSpotReadsPlainNextAsWeak) {
  const ParseOptions spot{.dialect = Dialect::Spot};
  expect_equal({"X a", "N a"}, spot);
  expect_equal({"X[!] a", "X a"}, spot);
  expect_equal({"XX[!] a", "N X a"}, spot);
  expect_equal({"○a", "N a"}, spot);
}

TEST(Parse, QuotedNamesAreAnyText) {
  Arena arena;
  const Formula f = parse(R"(F "red chair" & "U" & "say \"hi\" \\")", arena);
  EXPECT_EQ(
      f, conjunction(conjunction(eventually(arena.atom("red chair")), arena.atom("U")), arena.atom("say \"hi\" \\")));
}

TEST(Parse, LbtIsPrefix) {
  const ParseOptions lbt{.notation = Notation::Lbt};
  const Pair table[] = {
      {"U p0 G p1", "p0 U G p1"}, {"& | p0 p1 ! p2", "(p0 | p1) & !p2"},      {"i p0 e p1 p2", "p0 -> (p1 <-> p2)"},
      {"V t f", "true R false"},  {"^ W a M b c X d", "(a W (b M c)) ^ X d"}, {"!\"e\"", "!\"e\""},
  };
  for (const Pair& pair : table) expect_equal(pair, lbt);
}

TEST(Parse, PostfixIsTheFormOfThePaper) {
  const ParseOptions postfix{.notation = Notation::Postfix};
  const Pair table[] = {
      {"a b F &", "a & F b"},    {"a b c U ->", "a -> (b U c)"}, {"a", "a"},
      {"a X X[w] !", "! N X a"}, {"a F<=2", "F<=2 a"},
  };
  for (const Pair& pair : table) expect_equal(pair, postfix);
}

struct Bad {
  const char *text, *message;
  std::size_t column;
  Notation notation = Notation::Infix;
};

TEST(Parse, ErrorsNameWhatWasExpectedAndWhere) {
  const Bad table[] = {
      {"", "expected a formula", 1},
      {"   ", "expected a formula", 4},
      {"F (sofa U  )", "expected a formula after 'U'", 12},
      {"a &", "expected a formula after '&'", 4},
      {"a & & b", "expected a formula after '&'", 5},
      {"U a", "expected a formula", 1},
      {"(a | b", "expected ')' for the '(' in column 1", 7},
      {"a)", "expected the end of the formula or an operator: no '(' is open for this ')'", 2},
      {"◇sofa chair", "expected an operator or the end of the formula before 'chair'", 7},
      {"a (b)", "expected an operator or the end of the formula before '('", 3},
      {"(a) !b", "expected an operator or the end of the formula before '!'", 5},
      {"a & é", "'é' starts no part of a formula (names with such characters go in double quotes)", 5},
      {"a & 12", "expected a formula; numbers other than 0 and 1 must follow F<=, G<= or U<=", 5},
      {"F<= a", "expected a number of steps", 5},
      {"F[2:1] a", "the first number of steps is the smaller one", 2},
      {"F[3] a", "expected ':' and a second number of steps", 4},
      {"F[1:2 a", "expected ']' after the number of steps", 7},
      {"a R[1:2] b",
       "'[' starts no part of a formula; bounds stand right behind F, G or U: F[0:3], G<=3, U[1:3], F[2:]", 4},
      {"F[0:3 a", "expected ']' after the number of steps", 7},
      {"F \"sofa", "expected a closing '\"' for this one", 3},
      {"F \"\"", "expected a name between the quotes", 3},
      {"\"a\\t\"", "expected \\\", \\\\ or \\n in a quoted name", 3},
      {"a <- b", "'<' starts no part of a formula (names with such characters go in double quotes)", 3},
      {"G<=6000 a", "expected at most 10,000 levels of nesting (bounds count k times)", 1},
      {"a U<=4000 b", "expected at most 10,000 levels of nesting (bounds count k times)", 3},
      {"U p0", "expected a formula after 'p0'", 5, Notation::Lbt},
      {"U p0 p1 p2", "expected the end of the formula before 'p2'", 9, Notation::Lbt},
      {"(p0)", "expected no parentheses: the prefix form needs none", 1, Notation::Lbt},
      {"a &", "expected two formulas before '&'", 3, Notation::Postfix},
      {"F a", "expected a formula before 'F'", 1, Notation::Postfix},
      {"a b", "expected an operator: 2 formulas stand unconnected", 4, Notation::Postfix},
      {"", "expected a formula", 1, Notation::Postfix},
  };
  for (const Bad& bad : table) {
    Arena arena;
    try {
      const Formula f = parse(bad.text, arena, {.notation = bad.notation});
      ADD_FAILURE() << "'" << bad.text << "' was read as " << print(f);
    } catch (const SyntaxError& error) {
      EXPECT_EQ(error.message(), bad.message) << bad.text;
      EXPECT_EQ(error.column(), bad.column) << bad.text;
    }
  }
}

// The bytes that an error is about are whole characters, all of them.
TEST(Parse, ErrorsMarkWholeCharacters) {
  const struct {
    std::string_view before, wrong, behind;
  } table[] = {
      {"a & \"b", "\\t", "c\""}, {"a & \"b", "\\é", "c\""}, {"a & \"b", "\\◇", "c\""},
      {"a & \"b", "\\𝒰", "\""},  {"\"é", "\\\xC3", "\""},   {"a & ", "\"", "b\\\""},
      {"a & ", "\"", "b\\"},     {"F ", "\"\"", ""},        {"", "é", "◇"},
      {"◇ ", "♠", " a"},         {"◇ ", "𝒳", "b"},          {"◇ ", "\xF0", "\x9D b"},
      {"◇ ", "\x80", "\x80"},    {"F ", "7", "7"},          {"a & ", "[", "0:3] b"},
      {"F", "[3:1]", " a"},      {"G ", "[10,9]", "a"},
  };
  for (const auto& row : table) {
    const std::string text = std::string(row.before) + std::string(row.wrong) + std::string(row.behind);
    Arena arena;
    try {
      parse(text, arena);
      ADD_FAILURE() << text << " was read";
    } catch (const SyntaxError& error) {
      EXPECT_EQ(error.where().begin, row.before.size()) << error.what();
      EXPECT_EQ(error.where().end, row.before.size() + row.wrong.size()) << error.what();
    }
  }
}

TEST(Parse, UnknownPropositionsAreRejectedWithTheNearestName) {
  Arena arena(Vocabulary({"chair", "sofa"}));
  try {
    parse("F (sofa & X chiar)", arena, {.unknown = Unknown::Reject});
    FAIL() << "accepted";
  } catch (const SyntaxError& error) {
    EXPECT_STREQ(error.what(),
                 "unknown proposition 'chiar' (did you mean 'chair'?)\n"
                 "  1 | F (sofa & X chiar)\n"
                 "    |             ^^^^^");
  }
  EXPECT_EQ(arena.vocabulary().size(), 2U);
}

TEST(Parse, UnknownPropositionsBringTheKnownOnesToMind) {
  const auto message = [](const std::vector<std::string>& known) {
    Arena arena{Vocabulary(known)};
    try {
      parse("F zzzzzz", arena, {.unknown = Unknown::Reject});
    } catch (const SyntaxError& error) {
      return std::string(error.what()).substr(0, std::string(error.what()).find('\n'));
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message({}), "unknown proposition 'zzzzzz'");
  EXPECT_EQ(message({"a"}), "unknown proposition 'zzzzzz' (known: a)");
  EXPECT_EQ(message({"a", "b", "c"}), "unknown proposition 'zzzzzz' (known: a, b, c)");
  EXPECT_EQ(message({"a", "b", "c", "d", "e", "f", "g", "h"}),
            "unknown proposition 'zzzzzz' (known: a, b, c, d, e, f, g, h)");
  EXPECT_EQ(message({"a", "b", "c", "d", "e", "f", "g", "h", "i"}),
            "unknown proposition 'zzzzzz' (known: a, b, c, d, e, f, g, h, …)");
}

TEST(Parse, TheTextMayEndAnywhere) {
  const std::string whole = "F[ 1 : 3 ] (a U[<=2] \"b\\\"c\") <-> !X[!] X[w] G<=4 c";
  Arena arena;
  parse(whole, arena);
  for (std::size_t end = 0; end < whole.size(); ++end) {
    const std::string beginning = whole.substr(0, end);
    if (end == whole.find(" <->") || end == whole.find(" <->") + 1) continue;
    EXPECT_THROW(parse(beginning, arena), SyntaxError) << beginning;
  }
}

TEST(Parse, AnOpenQuoteIsUnderlinedAlone) {
  Arena arena;
  try {
    parse("F \"sofa", arena);
    FAIL() << "accepted";
  } catch (const SyntaxError& error) {
    EXPECT_STREQ(error.what(), "expected a closing '\"' for this one\n  1 | F \"sofa\n    |   ^");
  }
}

std::string repeat(const std::string& piece, std::size_t times) {
  std::string out;
  for (std::size_t i = 0; i < times; ++i) out += piece;
  return out;
}

TEST(Parse, DeepInputIsReadOrRefusedButNeverOverflows) {
  Arena arena;
  const Formula deep = parse(repeat("X ", most_levels - 1) + "a", arena);
  EXPECT_EQ(subformulas(deep).size(), most_levels);
  EXPECT_THROW(parse(repeat("X ", most_levels) + "a", arena), SyntaxError);
  EXPECT_THROW(parse(repeat("a U ", 200'000) + "a", arena), SyntaxError);
  EXPECT_THROW(parse(repeat("(", 200'000) + "a", arena), SyntaxError);
  EXPECT_EQ(parse(repeat("(", 50'000) + "a" + repeat(")", 50'000), arena), arena.atom("a"));
  EXPECT_THROW(parse(repeat("!", 200'000) + "a", arena), SyntaxError);
}

TEST(Parse, LongChainsMakeOneNodeEach) {
  Arena arena;
  std::string chain = "p0";
  for (std::size_t i = 1; i < 20'000; ++i) chain += " & p" + std::to_string(i);
  EXPECT_EQ(parse(chain, arena).operands().size(), 20'000U);
  EXPECT_EQ(arena.size(), 20'001U);
}

}  // namespace
}  // namespace waymark::ltl
