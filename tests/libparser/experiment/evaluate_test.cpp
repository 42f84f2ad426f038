#include "libparser/experiment/evaluate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/decode/grounder.hpp"
#include "libparser/language/generate.hpp"
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
    model.weights.row(model.weights.add(feature))[PostfixGrammar::stay] = 10.0F;
  Sentence stay{"1", "", {}, false, {{1, 9, 0}}, {{1, 9, 0}}, ""};
  Sentence walk{"2", "", {}, false, {{1, 9, 0}, {1, 8, 0}, {1, 7, 0}}, {{1, 9, 0}, {1, 8, 0}, {1, 7, 0}}, ""};
  Sentence turn{"3", "", {}, false, {{1, 9, 0}, {1, 9, 90}}, {{1, 9, 0}, {1, 9, 90}}, ""};
  Corpus corpus;
  corpus.paragraphs = {
      {"a", "grid", "", {stay, walk}}, {"b", "grid", "", {turn}}, {"c", "grid", "", {}}, {"d", "l", "", {walk}}};
  const Scores s = evaluate(GroundingFollower({grounder_of(std::move(model))}, {}), corpus, grid, Convention::Absolute);
  EXPECT_EQ(s.sentence.absolute.hits, 1U);
  EXPECT_EQ(s.sentence.absolute.total, 3U);
  EXPECT_EQ(s.sentence.relative.total, 0U);
  EXPECT_EQ(s.unheard.absolute.total, 0U) << "nothing is known of training";
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

// Does one thing, whatever is said, where the map lets it.
class OneStep : public Follower {
 public:
  Response follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const override {
    const plan::Action action = input.tokens.size() % 2 == 0 ? plan::Action::Forward : plan::Action::Left;
    const auto end = executor.map().successor(start, action);
    return end ? Response{*end, {action}, {}, 1} : Response{start, {}, {}, 1};
  }
  bool reads_formulas() const override { return false; }
};

TEST(Evaluate, CountsSentencesNeverHeardApart) {
  const plan::Map& grid = shipped_maps().front();
  const std::vector<plan::Pose> forward{{1, 9, 0}, {1, 8, 0}}, left{{1, 9, 0}, {1, 9, 270}};
  Corpus corpus;
  corpus.paragraphs = {{"a", "grid", "", {{"1", "", {"go", "on"}, false, forward, forward, ""}}},
                       {"b", "grid", "", {{"2", "", {"on", "go"}, false, forward, forward, ""}}},
                       {"c", "grid", "", {{"3", "", {"turn"}, false, forward, forward, ""}}},
                       {"d", "grid", "", {{"4", "", {"left"}, false, left, left, ""}}}};
  const HeardSentences heard{{"go", "on"}, {"left"}};
  const Scores s = evaluate(OneStep(), corpus, grid, Convention::Relative, nullptr, {}, &heard);
  EXPECT_EQ(s.sentence.relative.hits, 3U);
  EXPECT_EQ(s.sentence.relative.total, 4U);
  EXPECT_EQ(s.unheard.relative.hits, 1U);  // 2: the words of 1 in another order; 3 is wrong
  EXPECT_EQ(s.unheard.relative.total, 2U);
  EXPECT_EQ(s.unheard.absolute.total, 0U);
}

TEST(Evaluate, PredictionsCanBeScoredAgain) {
  const plan::Map& grid = shipped_maps().front();
  const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 8, .paragraphs = 30, .sentences = 3});
  for (const Convention convention : {Convention::Absolute, Convention::Relative}) {
    std::vector<Prediction> predictions;
    const Scores s = evaluate(OneStep(), corpus, grid, convention, &predictions);
    std::size_t sentences = 0, right = 0, elsewhere = 0;
    std::map<std::string, bool> paragraphs;  // does its last sentence end where it should?
    std::optional<std::string> before;
    plan::PoseId ended{};
    for (const Prediction& p : predictions) {
      EXPECT_EQ(p.convention, convention);
      EXPECT_EQ(p.map, "grid");
      if (!p.paragraph) {
        ++sentences;
        right += p.answer.end == p.gold_end ? 1 : 0;
        continue;
      }
      if (p.paragraph == before) {
        EXPECT_EQ(p.start, ended);
      }
      before = p.paragraph;
      ended = p.answer.end;
      paragraphs[*p.paragraph] = grid.node_of(ended) == grid.node_of(p.gold_end);
      elsewhere += ended == p.gold_end ? 0 : 1;
    }
    const bool absolute = convention == Convention::Absolute;
    const Percent by_sentence = absolute ? s.sentence.absolute : s.sentence.relative,
                  by_paragraph = absolute ? s.paragraph.absolute : s.paragraph.relative;
    EXPECT_EQ(by_sentence.total, sentences);
    EXPECT_EQ(by_sentence.hits, right);
    EXPECT_EQ(by_paragraph.total, paragraphs.size());
    EXPECT_EQ(by_paragraph.hits, static_cast<std::size_t>(std::count_if(paragraphs.begin(), paragraphs.end(),
                                                                        [](const auto& p) { return p.second; })));
    EXPECT_EQ(predictions.size(), 2 * sentences);
    EXPECT_GT(right, 0U);
    EXPECT_GT(elsewhere, 0U);
  }
}

TEST(Evaluate, LearnsItsOwnLanguageAcrossMaps) {
  const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 5, .paragraphs = testing::scaled(90), .sentences = 4});
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
