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
    ASSERT_EQ(instance.right.size(), 1U);
    for (std::size_t i = 0; i < instance.options.size(); ++i) {
      EXPECT_EQ(instance.options[i].start, instance.example->gold.start);
      EXPECT_EQ(instance.options[i].plan.end == instance.example->gold.end, i == instance.right.front());
    }
  }
  for (const RankingInstance& instance : setting().instances.of_starts) {
    ASSERT_LT(instance.right.size(), instance.options.size());
    for (std::size_t i = 0; i < instance.options.size(); ++i)
      EXPECT_EQ(instance.options[i].start == instance.example->gold.start,
                std::binary_search(instance.right.begin(), instance.right.end(), i));
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
    RerankerSentence sentence(model, instance.example->input);
    for (const RankingInstance::Option& option : instance.options)
      sentence.add_end(setting().executors[instance.example->map], option.start, option.plan, option.mass);
    const EndFeatures features = sentence.take();
    double all = 0, right = 0;
    for (std::size_t i = 0; i < features.ends.size(); ++i) {
      const auto weight = [&](std::uint64_t feature) {
        const std::uint32_t row = table.find(feature);
        return row == WeightTable::absent ? 0.0 : static_cast<double>(table.weight(row, 0));
      };
      double score = weight(log_mass_feature()) * static_cast<double>(features.log_mass[i]);
      for (const std::uint32_t bundle : features.ends[i])
        for (const std::uint64_t feature : features.bundles[bundle]) score += weight(feature);
      all += std::exp(score);
      if (std::binary_search(instance.right.begin(), instance.right.end(), i)) right += std::exp(score);
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
  const auto gain = [&](const WeightTable RankingModel::*table,
                        const std::vector<RankingInstance>& instances) {
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
