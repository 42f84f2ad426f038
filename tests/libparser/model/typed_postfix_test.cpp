#include "libparser/model/typed_postfix.hpp"

#include <gtest/gtest.h>

#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

class TypedPostfixTest : public ::testing::Test {
 protected:
  const ProgramLanguage language{shipped_maps().front().vocabulary()};
  const PostfixGrammar& grammar = language.grammar();
  TypedPostfix symbols{language};
};

TEST_F(TypedPostfixTest, SaysEveryProgramAndReadsItBack) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const Program program = random_program(grammar, random);
    const std::vector<Symbol> said = symbols.symbols_of(program);
    TypedState state;
    for (const Symbol symbol : said) {
      ASSERT_TRUE(symbols.allowed(state)[symbol]) << grammar.show(program) << " at " << symbols.name(symbol);
      if (const auto forced = symbols.forced(state)) {
        ASSERT_EQ(*forced, symbol);
      }
      state = symbols.after(state, symbol);
    }
    EXPECT_TRUE(state.prefix.ended);
    EXPECT_EQ(symbols.program_of(said), program);
  }
}

TEST_F(TypedPostfixTest, WhateverIsAllowedLeadsToAProgram) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    TypedState state;
    std::vector<Symbol> said;
    while (!state.prefix.ended) {
      const std::vector<bool> allowed = symbols.allowed(state);
      std::vector<Symbol> choices;
      for (Symbol v = 0; v < allowed.size(); ++v)
        if (allowed[v]) choices.push_back(v);
      ASSERT_FALSE(choices.empty());
      said.push_back(choices[random() % choices.size()]);
      state = symbols.after(state, said.back());
    }
    EXPECT_EQ(symbols.symbols_of(symbols.program_of(said)), said);
  }
}

TEST_F(TypedPostfixTest, PlacesMustBeNamed) {
  const std::vector<bool> named{false, false, true};  // the number 2
  const std::vector<bool> forbidden = symbols.forbidden(named);
  EXPECT_FALSE(forbidden[symbols.find(thing("2"))]);
  EXPECT_TRUE(forbidden[symbols.find(thing("3"))]);
  EXPECT_FALSE(forbidden[symbols.find(thing("chair"))]);
  EXPECT_EQ(symbols.find(thing("piano")), symbols.symbols());
}

}  // namespace
}  // namespace waymark::parser
