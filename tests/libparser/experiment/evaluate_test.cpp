#include "libparser/experiment/evaluate.hpp"

#include <gtest/gtest.h>

#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/linear/beam.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

// A corpus of one paragraph whose sentences are what the untrained model can be right or wrong about.
TEST(Evaluate, CountsSentencesParagraphsAndNodesByHand) {
  const plan::Map& grid = shipped_maps().front();
  // A model that answers `stay` to everything.
  LinearModel model(grid.vocabulary());
  const SentenceFeatures features = sentence_features({{}, false}, model.words);
  for (std::uint64_t feature : features.by_context[0][0])
    model.reader.row(model.reader.add(feature))[PostfixGrammar::stay] = 10.0F;
  Sentence stay{"1", "", {}, false, {{1, 9, 0}}, {{1, 9, 0}}, ""};
  Sentence walk{"2", "", {}, false, {{1, 9, 0}, {1, 8, 0}, {1, 7, 0}}, {{1, 9, 0}, {1, 8, 0}, {1, 7, 0}}, ""};
  Sentence turn{"3", "", {}, false, {{1, 9, 0}, {1, 9, 90}}, {{1, 9, 0}, {1, 9, 90}}, ""};
  Corpus corpus;
  corpus.paragraphs = {{"a", "grid", "", {stay, walk}},
                       {"b", "grid", "", {turn}},
                       {"c", "grid", "", {}},
                       {"d", "l", "", {walk}}};
  const Scores s =
      evaluate(GroundingFollower({grounder_of(std::move(model))}, {}), corpus, grid, Convention::Absolute);
  EXPECT_EQ(s.sentence.absolute.hits, 1U);
  EXPECT_EQ(s.sentence.absolute.total, 3U);
  EXPECT_EQ(s.sentence.relative.total, 0U);
  EXPECT_EQ(s.paragraph.absolute.hits, 1U);  // b: the right node, the wrong heading
  EXPECT_EQ(s.paragraph.absolute.total, 2U);
  EXPECT_EQ(s.skipped_paragraphs, 1U);
  EXPECT_EQ(s.satisfiable.hits, 3U);  // to stay can always be done
  EXPECT_EQ(s.satisfiable.total, 3U);
  EXPECT_EQ(s.path.precision.total, 0U);
  EXPECT_EQ(s.path.recall.total, 2U);
  EXPECT_EQ(s.path.recall.hits, 0U);
  EXPECT_EQ(s.path.accuracy.total, 3 * (grid.nodes().size() - 1));
  EXPECT_EQ(s.path.accuracy.total - s.path.accuracy.hits, 2U);
}

TEST(Evaluate, LearnsItsOwnLanguageAcrossMaps) {
  const Corpus corpus =
      generate_corpus(shipped_maps(), {.seed = 5, .paragraphs = testing::scaled(90), .sentences = 4});
  EvaluateOptions options;
  options.relative = false;
  const Evaluation result = evaluate_leave_one_map_out(corpus, nullptr, shipped_maps(), options);
  EXPECT_EQ(result.folds.size(), 3U);
  EXPECT_EQ(result.all.sentence.absolute.total, testing::scaled(360));
  EXPECT_GE(result.all.sentence.absolute.value(), testing::sanitized ? 25.0 : 80.0);
  EXPECT_EQ(result.all.sentence.relative.total, 0U);
}

TEST(Evaluate, FewerThanTwoMapsAreRefused) {
  const auto one = std::span(shipped_maps()).first(1);
  const Corpus corpus = generate_corpus(one, {.seed = 1, .paragraphs = 2, .sentences = 2});
  EXPECT_THROW(evaluate_leave_one_map_out(corpus, nullptr, one), std::invalid_argument);
  EXPECT_THROW(evaluate_leave_one_map_out(corpus, nullptr, {}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::parser
