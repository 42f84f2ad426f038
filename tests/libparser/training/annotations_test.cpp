#include "libparser/training/annotations.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/corpus_output.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/experiment/formula_scores.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/model_file.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

const ltl::Vocabulary& vocabulary() { return shipped_maps().front().vocabulary(); }

TEST(Annotations, LinesThatAreNoProgramsAreReportedWithTheirNumbers) {
  const Annotations read = parse_annotations(
      "# pairs\n"
      "go to the chair\tF chair\n"
      "\n"
      "never pass the sofa\tG !sofa\n"
      "go to the throne\tF throne\n"
      "half\tF (chair\n"
      "go to the lamp, not past the chair\t!chair U lamp\r\n",
      vocabulary(), Dialect::Temporal);
  ASSERT_EQ(read.pairs.size(), 2U);
  EXPECT_EQ(read.pairs[1].text, "go to the lamp, not past the chair");
  EXPECT_EQ(read.pairs[1].formula, "!chair U lamp");
  EXPECT_EQ(read.pairs[1].line, 7U);
  ASSERT_EQ(read.refused.size(), 3U);
  EXPECT_EQ(read.refused[0].line, 4U);
  EXPECT_EQ(read.refused[1].line, 5U);
  EXPECT_EQ(read.refused[2].line, 6U);
  EXPECT_THROW(parse_annotations("no tab", vocabulary(), Dialect::Plain), ltl::FormatError);
  EXPECT_THROW(parse_annotations("\tF chair", vocabulary(), Dialect::Plain), ltl::FormatError);
}

// Some of our own language, as `waymark generate corpus` writes it.
const Annotations& pairs_of_ours() {
  static const Annotations read = parse_annotations(
      pairs_text(generate_corpus(
          shipped_maps(),
          {.seed = 2, .paragraphs = 15, .sentences = 4, .dialect = Dialect::Temporal, .most_clauses = 2})),
      vocabulary(), Dialect::Temporal);
  return read;
}

FormulaScores scores_on_pairs(const Grounder& grounder) {
  FormulaJudge judge(vocabulary(), Dialect::Temporal);
  for (const Annotation& pair : pairs_of_ours().pairs) {
    const auto read =
        likely_programs(grounder, {tokenize(pair.text), false}, {.clauses = false});  // as its reader reads it
    judge.judge(pair.formula, read.empty() ? Program{} : read.front().program);
  }
  return judge.scores();
}

TEST(Annotations, EveryGeneratedFormulaIsRecognised) {
  EXPECT_EQ(pairs_of_ours().pairs.size(), 60U);
  EXPECT_TRUE(pairs_of_ours().refused.empty());
}

TEST(Supervised, ASmallSetOfPairsIsLearnedByHeart) {
  TrainOptions options;
  options.dialect = Dialect::Temporal;
  options.mirrored = false;
  options.learning_rate = 0.1;
  options.decay = 0;
  options.epochs = 30;
  options.network.epochs = 200;
  options.network.dropout = options.network.word_dropout = 0;
  options.network.sizes = {.word = 24, .width = 24, .query = 32, .symbol = 16, .history = 4};
  for (const ReaderKind kind : {ReaderKind::Linear, ReaderKind::EncoderDecoder}) {
    options.reader = kind;
    const Grounder grounder = train_supervised(pairs_of_ours().pairs, shipped_maps().front(), options);
    const FormulaScores scores = scores_on_pairs(grounder);
    EXPECT_EQ(scores.all.same.hits, scores.all.same.total) << static_cast<int>(kind);
    EXPECT_EQ(scores.all.equivalent.hits, pairs_of_ours().pairs.size()) << static_cast<int>(kind);
    // The dialect is saved with the model.
    const Grounder saved = parse_grounder(serialize(grounder));
    EXPECT_EQ(saved.ranking->language.dialect(), Dialect::Temporal);
    EXPECT_EQ(serialize(saved), serialize(grounder));
  }
}

TEST(Supervised, NothingToLearnFromIsRefused) {
  EXPECT_THROW(train_supervised({}, shipped_maps().front(), {}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::parser
