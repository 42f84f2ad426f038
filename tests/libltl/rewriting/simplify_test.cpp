#include "libltl/rewriting/simplify.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/implication.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/rewrite_rules.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/support/generate.hpp"

namespace waymark::ltl {
namespace {

using testing::show;

struct Row {
  const char* rule;
  const char *match, *result;
};

// At least one row for each rule.
constexpr Row rows[] = {
    {"weak next is next", "N a", "X a"},
    {"there is a next", "X true", "true"},
    {"there is a next", "N false", "false"},
    {"next of a constant", "X false", "false"},
    {"next of a constant", "N true", "true"},
    {"constant on the right", "a U false", "false"},
    {"constant on the right", "a R true", "true"},
    {"until by its right side", "a U a", "a"},
    {"until by its right side", "false U a", "a"},
    {"until by its right side", "(a & b) U (a | F b)", "a | F b"},
    {"until by its right side", "F true", "true"},
    {"release by its right side", "a R a", "a"},
    {"release by its right side", "true R a", "a"},
    {"release by its right side", "a R false", "false"},
    {"idle on the left", "!a U a", "F a"},
    {"idle on the left", "a R !a", "G !a"},
    {"idle on the left", "(!a & b) U a", "b U a"},
    {"idle on the left", "(a | b) R !a", "b R !a"},
    {"absorbed on the left", "a U (a U b)", "a U b"},
    {"absorbed on the left", "a U F b", "F b"},
    {"absorbed on the left", "a R G b", "G b"},
    {"repeated on the left", "(a U b) U b", "a U b"},
    {"repeated on the left", "(a R b) R b", "a R b"},
    {"guard under eventually", "F(a U b)", "F b"},
    {"guard under eventually", "G(a R b)", "G b"},
    {"guard in a junction", "F(c | (a U b))", "F(c | b)"},
    {"guard in a junction", "G(c & G b)", "G(c & b)"},
    {"recurring", "F G F a", "G F a"},
    {"recurring", "G F G a", "F G a"},
    {"at the end", "G F a", "F G a"},
    {"next outwards", "X a U X b", "X(a U b)"},
    {"next outwards", "F X a", "X F a"},
    {"next outwards", "G N a", "N G a"},
    {"next outwards", "N a R N b", "N(a R b)"},
    {"next out of release", "X a R X b", "X(a R b)"},
    {"next out of release", "G X a", "X G a"},
    {"settled beside", "a | ((a | b) & c)", "a | (b & c)"},
    {"settled beside", "F a & ((F a & b) | c)", "F a & (b | c)"},
    {"settled beside", "a | (c & d & (a | b))", "a | (c & d & b)"},
    {"absorbed", "a & F a", "a"},
    {"absorbed", "a | F a", "F a"},
    {"absorbed", "b & (a U b) & c", "b & c"},
    {"absorbed", "X a & N a", "X a"},
    {"contradiction", "a & c & G !a", "false"},
    {"contradiction", "a | c | F !a", "true"},
    {"contradiction", "G a & X X F !a", "false"},
    {"factored", "(a | b) & (a | c)", "a | (b & c)"},
    {"factored", "(a & b) | (a & c & X b)", "a & (b | (c & X b))"},
    {"nexts joined", "X a & X b & c", "X(a & b) & c"},
    {"nexts joined", "X a & N b", "X(a & b)"},
    {"nexts joined", "X a | N b", "N(a | b)"},
    {"nexts joined", "X a | X b", "X(a | b)"},
    {"joined by and", "G a & G b", "G(a & b)"},
    {"joined by and", "(a U c) & (b U c)", "(a & b) U c"},
    {"joined by or", "F a | F b", "F(a | b)"},
    {"joined by or", "(a R c) | (b R c)", "(a | b) R c"},
    {"recurring joined", "F G a & F G b", "F G(a & b)"},
    {"recurring joined", "G F a | G F b", "G F(a | b)"},
};

const RewriteRule& rule_named(std::string_view name) {
  for (const RewriteRule& rule : rewrite_rules())
    if (rule.name == name) return rule;
  throw std::out_of_range("no rule named " + std::string(name));
}

TEST(RewriteRules, EachDoesWhatItsCommentSays) {
  std::set<std::string_view> without_row;
  for (const RewriteRule& rule : rewrite_rules()) without_row.insert(rule.name);
  for (const Row& row : rows) {
    Arena arena;
    Implication implies;
    const auto result = rule_named(row.rule).apply(parse(row.match, arena), implies);
    ASSERT_TRUE(result) << row.rule << " does not match " << row.match;
    EXPECT_EQ(*result, parse(row.result, arena)) << row.match << " became " << print(*result);
    without_row.erase(row.rule);
  }
  EXPECT_TRUE(without_row.empty()) << *without_row.begin() << " has no row";
}

// Formulas on which rules have something to do: all small ones, and random ones of the size of the tables above.
std::vector<Formula> subjects(Arena& arena) {
  std::vector<Formula> out = testing::all_formulas(arena, {.size = 4, .atoms = 2});
  Random random(5);
  for (int i = 0; i < 1'000; ++i) out.push_back(nnf(random_formula(random, arena, {.size = 9, .atoms = 2})));
  for (const Row& row : rows) out.push_back(parse(row.match, arena));
  return out;
}

// The first word that tells f from g, shown; empty when there is none.
template <class Word>
std::string difference(Formula f, Formula g, const std::vector<Word>& words) {
  for (const Word& word : words)
    if (holds(word, f) != holds(word, g)) return show(f, word) + "   became: " + print(g);
  return "";
}

TEST(Laws, EveryRuleHoldsWhereItSaysAndNowhereElse) {
  Arena arena(testing::letters_vocabulary(3));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  const auto lassos = testing::all_lassos({.length = 2, .atoms = 2});
  const std::vector<Formula> formulas = subjects(arena);
  for (const RewriteRule& rule : rewrite_rules()) {
    Implication implies;
    std::string against_finite, against_infinite;
    for (Formula f : formulas) {
      const auto result = rule.apply(f, implies);
      if (!result) continue;
      if (against_finite.empty()) against_finite = difference(f, *result, words);
      if (against_infinite.empty()) against_infinite = difference(f, *result, lassos);
    }
    EXPECT_EQ(against_finite.empty(), rule.finite) << rule.name << ": " << against_finite;
    EXPECT_EQ(against_infinite.empty(), rule.infinite) << rule.name << ": " << against_infinite;
  }
}

TEST(Laws, ImplicationIsSound) {
  Arena arena(testing::letters_vocabulary(2));
  const auto formulas = testing::all_formulas(arena, {.size = 3, .atoms = 2});
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  const auto lassos = testing::all_lassos({.length = 2, .atoms = 2});
  Implication implies;
  std::size_t found = 0;
  for (Formula f : formulas)
    for (Formula g : formulas) {
      if (!implies(f, g)) continue;
      ++found;
      const Formula claim = ltl::implies(f, g);
      for (const Trace& word : words) ASSERT_TRUE(holds(word, claim)) << show(claim, word);
      for (const Lasso& word : lassos) ASSERT_TRUE(holds(word, claim)) << show(claim, word);
    }
  EXPECT_GT(found, 4 * formulas.size());  // more than φ ⇒ φ, false ⇒ φ, φ ⇒ true
}

// What must hold of g, made of f, besides saying the same of every word.
void expect_sound(Formula f, Formula g, Over over) {
  if (over == Over::Rest) {
    ASSERT_EQ(accepts_empty(f), accepts_empty(g)) << show(f) << " became " << print(g);
  }
  ASSERT_EQ(simplify(g, over), g) << show(f) << " became " << print(g);
  ASSERT_LE(tree_size(g), tree_size(nnf_keeping_iff(f))) << show(f) << " became " << print(g);
}

TEST(Laws, SimplifyKeepsTheMeaningAndNeverGrows) {
  Arena arena(testing::letters_vocabulary(3));
  const auto words = testing::all_traces({.length = 3, .atoms = 2});
  const auto lassos = testing::all_lassos({.length = 2, .atoms = 2});
  for (Formula f : subjects(arena)) {
    const Formula finite = simplify(f, Over::Finite), rest = simplify(f, Over::Rest);
    const Formula infinite = simplify(f, Over::Infinite);
    if (finite != f) {
      ASSERT_EQ(difference(f, finite, words), "");
    }
    if (rest != finite) {
      ASSERT_EQ(difference(f, rest, words), "");
    }
    if (infinite != f) {
      ASSERT_EQ(difference(f, infinite, lassos), "");
    }
    expect_sound(f, finite, Over::Finite);
    expect_sound(f, rest, Over::Rest);
    expect_sound(f, infinite, Over::Infinite);
  }
}

TEST(Conventions, WhatProgressionLeavesKeepsTheEndOfTheWord) {
  Arena arena;
  const auto as = [&](const char* text, Over over) { return print(simplify(parse(text, arena), over)); };
  EXPECT_EQ(as("a & F true", Over::Finite), "a");
  EXPECT_EQ(as("a & F true", Over::Infinite), "a");
  EXPECT_EQ(as("X(a & F true)", Over::Rest), "X a");
  EXPECT_EQ(as("F true", Over::Rest), "F true");
  EXPECT_EQ(as("a | G false", Over::Rest), "a | G false");
  EXPECT_EQ(as("a | G false", Over::Finite), "a");
}

TEST(Simplify, WorksAsAWhole) {
  const struct {
    const char* text;
    Over over;
    const char* simplified;
  } table[] = {
      {"!(true U !a)", Over::Finite, "G a"},
      {"X X X true & X a", Over::Infinite, "X a"},
      {"F(a & F(b | F b))", Over::Finite, "F(a & F b)"},
      {"G(a -> F true)", Over::Finite, "true"},
      {"F a | F(b | (c U a))", Over::Finite, "F(a | b)"},
      {"(a <-> X true) & X a", Over::Infinite, "a & X a"},
  };
  for (const auto& row : table) {
    Arena arena;
    EXPECT_EQ(print(simplify(parse(row.text, arena), row.over)), row.simplified);
  }
}

TEST(Simplify, EndsEarlyWithTheSameMeaning) {
  std::stop_source source;
  source.request_stop();
  Arena arena;
  const Formula f = parse("!(a U (b & G a)) & F(a | F a)", arena);
  EXPECT_EQ(simplify(f, Over::Infinite, {}, source.get_token()), nnf_keeping_iff(f));
}

TEST(Simplify, LongJunctionsAreNotComparedTwoByTwo) {
  Arena arena;
  std::vector<Formula> all;
  for (int i = 0; i < 100'000; ++i) all.push_back(eventually(arena.atom("p" + std::to_string(i))));
  const Formula f = conjunction(arena, all);
  EXPECT_EQ(simplify(f, Over::Infinite), f);  // for hours, if they were
}

TEST(Simplify, DeepFormulasDoNotOverflow) {
  Arena arena;
  Formula f = arena.atom("a");
  for (std::size_t i = 1; i < most_levels; ++i) f = i % 2 == 0 ? until(f, arena.atom("b")) : negate(next(f));
  EXPECT_LE(tree_size(simplify(f, Over::Rest)), tree_size(f));
}

}  // namespace
}  // namespace waymark::ltl
