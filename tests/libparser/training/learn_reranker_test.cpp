#include "libparser/training/learn_reranker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libparser/language/generate.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

// RankingInstances of one map, by a reader of the others.
struct Setting {
  std::vector<Executor> executors{shipped_maps().begin(), shipped_maps().end()};
  TrainOptions options;
  Examples examples;
  std::vector<const Example*> heard;
  Grounder reader;
  RankingInstances instances;

  Setting() {
    const Corpus corpus =
        generate_corpus(shipped_maps(), {.seed = 3, .paragraphs = testing::scaled(60), .sentences = 4});
    examples = make_examples(corpus, executors, Convention::Absolute);
    find_programs(examples.sentences, executors, PostfixGrammar(shipped_maps().front().vocabulary()), 1,
                  [](double) { return true; });
    options.epochs = 1;
    std::vector<const Example*> others;
    for (const Example& example : examples.sentences) (example.map == 2 ? heard : others).push_back(&example);
    reader = learn_reader(others, executors, options, [](double) {});
    add_ranking_instances(reader, heard, executors, options, instances);
  }
};

const Setting& setting() {
  static const Setting setting;
  return setting;
}

TEST(LearnReranker, OfEndsTheGoldOneIsRightOfStartsTheGoldOne) {
  ASSERT_FALSE(setting().instances.of_ends.empty());
  ASSERT_FALSE(setting().instances.of_starts.empty());
  for (const RankingInstance& instance : setting().instances.of_ends) {
    ASSERT_GT(instance.candidates.size(), 1U);
    std::size_t right = 0;
    for (const auto& [route, mass] : instance.candidates) {
      EXPECT_EQ(route.start, instance.example->gold.start);
      EXPECT_EQ(route.plan.end == instance.example->gold.end, Hallways::right(instance, route));
      right += Hallways::right(instance, route) ? 1U : 0U;
    }
    EXPECT_EQ(right, 1U);
  }
  for (const RankingInstance& instance : setting().instances.of_starts) {
    std::size_t right = 0;
    for (const auto& [route, mass] : instance.candidates) {
      EXPECT_EQ(route.start == instance.example->gold.start, Hallways::right(instance, route));
      right += Hallways::right(instance, route) ? 1U : 0U;
    }
    EXPECT_GT(right, 0U);
    EXPECT_LT(right, instance.candidates.size());
  }
}

// Sentences that begin a paragraph, or begin elsewhere than where the last one ended, say nothing about starts.
TEST(LearnReranker, StartsAreAskedForOnlyWhereAParagraphGoesOn) {
  for (const RankingInstance& instance : setting().instances.of_starts) {
    const Example& example = *instance.example;
    const auto it = std::find(setting().heard.begin(), setting().heard.end(), &example);
    ASSERT_NE(it, setting().heard.begin());
    const Example& before = **(it - 1);
    EXPECT_EQ(before.paragraph, example.paragraph);
    EXPECT_EQ(before.position + 1, example.position);
    EXPECT_EQ(before.gold.end, example.gold.start);
  }
}

// log p(right) of a table, by the definition; mean over instances.
double log_likelihood(const RankingModel& model, const WeightTable& table,
                      const std::vector<RankingInstance>& instances) {
  double sum = 0;
  for (const RankingInstance& instance : instances) {
    const CandidateFeatures features =
        Hallways(model, setting().executors).features({&instance, false}, instance.candidates);
    double all = 0, right = 0;
    for (std::size_t i = 0; i < features.candidates.size(); ++i) {
      const auto weight = [&](std::uint64_t feature) {
        const auto row = table.find(feature);
        return row ? static_cast<double>(table.weight(*row, 0)) : 0.0;
      };
      double score = 0;
      for (const std::uint32_t bundle : features.candidates[i])
        for (const auto& [feature, value] : features.bundles[bundle])
          score += weight(feature) * static_cast<double>(value);
      all += std::exp(score);
      if (Hallways::right(instance, instance.candidates[i].route)) right += std::exp(score);
    }
    sum += std::log(right / all);
  }
  return sum / static_cast<double>(instances.size());
}

TEST(LearnReranker, WhatIsRightBecomesLikelier) {
  const auto learned = [&](int epochs) {
    TrainOptions options = setting().options;
    options.reranker_epochs = epochs;
    return with_reranker(setting().reader, setting().instances, setting().executors, options, [](double) {});
  };
  const Grounder before = learned(0), after = learned(6);
  const auto gain = [&](const WeightTable RankingModel::*table, const std::vector<RankingInstance>& instances) {
    return log_likelihood(*after.ranking, (*after.ranking).*table, instances) -
           log_likelihood(*before.ranking, (*before.ranking).*table, instances);
  };
  EXPECT_GT(gain(&RankingModel::reranker, setting().instances.of_ends), 0.1);
  EXPECT_GT(gain(&RankingModel::start_pose_model, setting().instances.of_starts), 0.1);
  // Each from its own instances: the reranker is the worse start-pose model.
  EXPECT_GT(log_likelihood(*after.ranking, after.ranking->start_pose_model, setting().instances.of_starts),
            log_likelihood(*after.ranking, after.ranking->reranker, setting().instances.of_starts));
}

}  // namespace
}  // namespace waymark::parser
