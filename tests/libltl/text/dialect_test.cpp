// Dialects: what each reads differently, and words that must not become new names in silence.
#include "libltl/text/dialect.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

namespace waymark::ltl {
namespace {

constexpr Dialect all_dialects[] = {Dialect::Waymark, Dialect::Spot, Dialect::Nusmv, Dialect::Psl};

std::string read(std::string_view text, Dialect dialect) {
  Arena arena;
  return print(parse(text, arena, {.dialect = dialect}));
}

std::string refusal(std::string_view text, Dialect dialect, Unknown unknown = Unknown::Add) {
  Arena arena;
  try {
    return "read as " + print(parse(text, arena, {.dialect = dialect, .unknown = unknown}));
  } catch (const SyntaxError& error) {
    return error.message();
  }
}

TEST(Dialect, SpotSplitsWordsThatBeginWithOperators) {
  const std::pair<const char*, const char*> table[] = {{"GFa", "G F a"},
                                                       {"FGXXa", "F G N N a"},
                                                       {"XX1", "N X1"},
                                                       {"G1 & F2x", "G1 & F2x"},
                                                       {"aUb", "aUb"},
                                                       {"(a)Ub", "a U b"},
                                                       {"p Uq", "p U q"},
                                                       {"p UGFq", "p U (G F q)"},
                                                       {"Ua", "Ua"},
                                                       {"Ffalse", "F false"},
                                                       {"FALSE", "false"},
                                                       {"a-->b<-->c", "a -> (b <-> c)"},
                                                       {"X[2]a", "N N a"},
                                                       {"X[2!]a", "X X a"},
                                                       {"G\"Fa\"", "G Fa"},
                                                       {"Mutex & Ready", "Mutex & Ready"},
                                                       {"!Xa | Gb", "N a -> G b"}};
  for (const auto& [text, meant] : table) EXPECT_EQ(read(text, Dialect::Spot), meant) << text;
  EXPECT_EQ(read("GFa & Xp0", Dialect::Waymark), "GFa & Xp0");
}

TEST(Dialect, BindsAsItsToolDoes) {
  struct {
    const char* text;
    const char* waymark;
    const char* spot;
    const char* nusmv;
    const char* psl;
  } table[] = {
      {"a -> b <-> c", "(a -> b) <-> c", "a -> (b <-> c)", "a -> (b <-> c)", "a -> (b <-> c)"},
      {"a <-> b -> c", "a <-> (b -> c)", "a <-> (b -> c)", "(a <-> b) -> c", "a <-> (b -> c)"},
      {"a xor b | c", "a ^ (b | c)", "(a ^ b) | c", "(a ^ b) | c", "(a ^ b) | c"},
      {"a | b xor c", "(a | b) ^ c", "a | (b ^ c)", "(a | b) ^ c", "a | (b ^ c)"},
      {"a U b U c", "a U (b U c)", "a U (b U c)", "(a U b) U c", "a U (b U c)"},
      {"G a -> b", "(G a) -> b", "(G a) -> b", "(G a) -> b", "G (a -> b)"},
      {"F a & b", "(F a) & b", "(F a) & b", "(F a) & b", "F (a & b)"},
      {"a U b & c", "(a U b) & c", "(a U b) & c", "(a U b) & c", "a U (b & c)"},
      {"F a U b", "(F a) U b", "(F a) U b", "(F a) U b", "(F a) U b"},
      {"a & G b -> c & d", "(a & G b) -> (c & d)", "(a & G b) -> (c & d)", "(a & G b) -> (c & d)",
       "a & G (b -> (c & d))"},
  };
  for (const auto& row : table) {
    const char* meant[] = {row.waymark, row.spot, row.nusmv, row.psl};
    for (const Dialect dialect : all_dialects) {
      Arena arena;
      EXPECT_EQ(parse(row.text, arena, {.dialect = dialect}), parse(meant[static_cast<int>(dialect)], arena))
          << row.text << " in dialect " << static_cast<int>(dialect);
    }
  }
}

// Parentheses leave nothing to precedence: all dialects agree on what they all spell alike.
TEST(Dialect, AgreesWithEveryOtherOnFormulasInParentheses) {
  for (const char* text : {"G (a -> (F b))", "(a U b) & (!(c))", "(a V b) | (a xor c)", "F (G (a <-> b))"})
    for (const Dialect dialect : all_dialects) EXPECT_EQ(read(text, dialect), read(text, Dialect::Waymark)) << text;
}

TEST(Dialect, NusmvComparesNames) {
  Arena arena;
  const Formula f = parse("G (state = idle -> x>=-3 & !(y.z != 2))", arena, {.dialect = Dialect::Nusmv});
  EXPECT_EQ(arena.vocabulary().names(), (std::vector<std::string>{"state = idle", "x >= -3", "y.z != 2"}));
  EXPECT_EQ(read(print(f), Dialect::Nusmv), print(f)) << "quoted, conditions are the same propositions";
  EXPECT_EQ(read("a=>b <=> c<->d", Dialect::Nusmv), read("a -> (b <-> c) <-> d", Dialect::Nusmv));
  EXPECT_EQ(refusal("a = ", Dialect::Nusmv), "expected a number or a name to compare with");
}

TEST(Dialect, WordsOfOtherToolsNeverBecomeNewNamesInSilence) {
  for (const char* word : {"TRUE",    "True",     "FALSE",   "False", "and",    "or",           "not",        "AND",
                           "Not",     "implies",  "iff",     "next",  "always", "never",        "eventually", "until",
                           "release", "globally", "finally", "since", "once",   "historically", "last",       "end"}) {
    for (const std::string& text : {std::string(word), "G (p -> " + std::string(word) + ")"}) {
      EXPECT_NE(refusal(text, Dialect::Waymark).find("did you mean "), std::string::npos) << text;
      EXPECT_NE(refusal(text, Dialect::Waymark, Unknown::Reject).find(text == word ? "did you mean " : "unknown"),
                std::string::npos)
          << text;
      for (const Dialect dialect : all_dialects)
        EXPECT_NE(refusal(text, dialect), "read as " + text) << static_cast<int>(dialect);
    }
    const std::string quoted = '"' + std::string(word) + '"';
    EXPECT_EQ(read(quoted, Dialect::Waymark), quoted) << "quotes make a name of any word, and are printed";
    Arena arena(Vocabulary({word}));
    EXPECT_EQ(print(parse(word, arena)), quoted) << "a name that the letters have is that name";
  }
}

TEST(Dialect, WhatIsNotReadIsCalledByItsName) {
  const struct {
    Dialect dialect;
    const char *text, *says;
  } table[] = {
      {Dialect::Waymark, "AG p", "CTL"},
      {Dialect::Waymark, "A(p)", "CTL"},
      {Dialect::Waymark, "E[p U q]", "CTL"},
      {Dialect::Nusmv, "EF (p & q)", "CTL"},
      {Dialect::Waymark, "p and q", "did you mean '&'?"},
      {Dialect::Waymark, "p --> q", "did you mean '->'?"},
      {Dialect::Waymark, "p <==> q", "did you mean '<->'?"},
      {Dialect::Nusmv, "next(p)", "next(…)"},
      {Dialect::Psl, "always {a; b} |=> c", "sequences"},
      {Dialect::Psl, "a before! b", "before"},
      {Dialect::Psl, "a until_ b", "until_"},
      {Dialect::Psl, "next_event(a)(b)", "next_event"},
      {Dialect::Psl, "eventually a", "did you mean 'eventually!'?"},
  };
  for (const auto& row : table)
    EXPECT_NE(refusal(row.text, row.dialect).find(row.says), std::string::npos)
        << row.text << ": " << refusal(row.text, row.dialect);
  EXPECT_EQ(read("A & E", Dialect::Waymark), "A & E") << "as names they are read";
}

TEST(Dialect, NamesThatLookLikeOperatorsAreSpelledApart) {
  const std::pair<const char*, const char*> table[] = {{"GFa", "G F a"}, {"XXready", "X X ready"},
                                                       {"Fp0", "F p0"},  {"Xq", "X q"},
                                                       {"Goal", ""},     {"Front", ""},
                                                       {"X1", ""},       {"GO", ""},
                                                       {"G", ""},        {"a", ""},
                                                       {"Na", ""}};
  for (const auto& [name, apart] : table) EXPECT_EQ(spelled_apart(name), apart) << name;
}

}  // namespace
}  // namespace waymark::ltl
