#include "libparser/programs/recognise.hpp"

#include <gtest/gtest.h>

#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

std::string read(const char* text, Dialect dialect = Dialect::Temporal) {
  const PostfixGrammar grammar(shipped_maps().front().vocabulary(), dialect);
  ltl::Arena arena(shipped_maps().front().vocabulary());
  const auto program = program_of(ltl::parse(text, arena), grammar);
  return program ? grammar.show(*program) : "none";
}

TEST(Recognise, FindsTheProgramOfAFormula) {
  const std::pair<const char*, const char*> table[] = {
      {"true", "stay"},
      {"F chair", "chair reach"},
      {"F (sofa & chair)", "chair sofa & reach"},
      {"F (chair & F sofa)", "chair reach sofa reach then"},
      {"X (moved & X moved)", "forward_2"},
      {"X (turned_left & F sofa)", "turned_left next sofa reach then"},
      {"X (moved U (moved & lamp & X moved))", "lamp past"},
      {"X (moved U (moved & tee & X (moved U (moved & tee))))", "tee advance_2"},
      {"!sofa U (chair & F sofa)", "sofa without chair reach apply sofa reach then"},
      {"blue U chair", "blue keep chair reach apply"},
      {"(ahead_wall & X turned_left) | !ahead_wall", "ahead_wall when turned_left next apply"},
      {"(tee & X turned_left) | (!tee & X moved)", "tee whether turned_left next apply forward_1 apply"},
  };
  for (const auto& [text, program] : table) EXPECT_EQ(read(text), program) << text;
}

TEST(Recognise, WhatIsNoProgramIsNotTakenForOne) {
  for (const char* text : {"G chair", "F chair & F sofa", "!chair", "chair U (sofa | lamp)", "N chair", "false",
                           "(tee & X turned_left) | (chair & X moved)", "F moved", "X (moved & chair)"})
    EXPECT_EQ(read(text), "none") << text;
  EXPECT_EQ(read("!sofa U chair", Dialect::Plain), "none");
  EXPECT_EQ(read("F chair", Dialect::Plain), "chair reach");
}

// ¬l ∧ … ∧ l is false: what is owed there cannot be seen in the formula.
bool names_a_condition_again(const Program& program) {
  for (std::size_t i = 0; i < program.size(); ++i)
    for (std::size_t j = 0; j < program.size(); ++j)
      for (const std::uint16_t p : program[j].literals())
        if (i != j && operands(program[i].kind) > 0 && p == program[i].goal[0]) return true;
  return false;
}

TEST(Recognise, EveryProgramIsFoundFromItsFormula) {
  const plan::Map& map = shipped_maps().front();
  std::mt19937_64 random(17);
  std::size_t seen = 0;
  for (const PostfixGrammar::Limits limits :
       {PostfixGrammar::limits_of(Dialect::Plain), PostfixGrammar::Limits{4, 2, Dialect::Temporal}}) {
    const PostfixGrammar grammar(map.vocabulary(), limits);
    for (int i = 0; i < 3000; ++i) {
      const Program program = random_program(grammar, random);
      if (names_a_condition_again(program)) continue;
      ++seen;
      ltl::Arena arena(map.vocabulary());
      const ltl::Formula formula = formula_of(program, arena);
      const auto found = program_of(formula, grammar);
      ASSERT_TRUE(found.has_value()) << grammar.show(program) << "  =  " << ltl::print(formula);
      ASSERT_EQ(formula_of(*found, arena), formula) << grammar.show(program) << " and " << grammar.show(*found);
    }
  }
  EXPECT_GT(seen, 5'000U);
}

}  // namespace
}  // namespace waymark::parser
