#include "libparser/supervision/constrained_search.hpp"

#include <gtest/gtest.h>

#include <map>

#include "libltl/text/parse.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/supervision/examples.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

class SaidSearchTest : public ::testing::Test {
 protected:
  std::vector<Consistent> search(const Example& example) {
    return said_programs(executors[example.map], language, example.gold, example.input.tokens, plans[example.map]);
  }

  const std::vector<Executor> executors{shipped_maps().begin(), shipped_maps().end()};
  const ProgramLanguage language{shipped_maps().front().vocabulary(), Dialect::Temporal};
  std::map<std::size_t, UnitPlans> plans;
};

TEST_F(SaidSearchTest, ProgramsAreOfTheDialectAndEndAtTheGoldEnd) {
  const Corpus corpus =
      generate_corpus(shipped_maps(), {.seed = 6, .paragraphs = 12, .dialect = Dialect::Temporal, .most_clauses = 3});
  std::size_t found = 0;
  for (const Example& example : make_examples(corpus, executors, Convention::Absolute).sentences)
    for (const Consistent& one : search(example)) {
      ++found;
      ASSERT_TRUE(language.grammar().contains(one.program));
      const auto plan = executors[example.map].run(one.program, example.gold.start);
      ASSERT_TRUE(plan.has_value()) << language.grammar().show(one.program);
      EXPECT_EQ(plan->end, example.gold.end) << language.grammar().show(one.program);
      EXPECT_EQ(plan->actions == example.gold.actions, one.same_route) << language.grammar().show(one.program);
    }
  EXPECT_GT(found, 200U);
}

// Of two clauses, what was meant is mostly among them, though no formula was looked at. A quarter of what is avoided
// makes no difference to the route, and is not found.
TEST_F(SaidSearchTest, WhatWasMeantIsAmongThem) {
  const Corpus corpus =
      generate_corpus(shipped_maps(), {.seed = 7, .paragraphs = 20, .dialect = Dialect::Temporal, .most_clauses = 2});
  const Examples examples = make_examples(corpus, executors, Convention::Absolute);
  std::size_t i = 0, meant = 0;
  for (const Paragraph& paragraph : corpus.paragraphs)
    for (const Sentence& sentence : paragraph.sentences) {
      ltl::Arena arena(language.vocabulary());
      const ltl::Formula gold = ltl::parse(sentence.formula, arena);
      const auto programs = search(examples.sentences[i++]);
      meant += std::any_of(programs.begin(), programs.end(),
                           [&](const Consistent& one) { return formula_of(one.program, arena) == gold; });
    }
  EXPECT_EQ(i, 80U);
  EXPECT_GE(meant, 50U);
}

}  // namespace
}  // namespace waymark::parser
