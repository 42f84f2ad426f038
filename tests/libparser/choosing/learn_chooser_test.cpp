#include "libparser/choosing/learn_chooser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libparser/language/generate.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

// Dilemmas of one map, by a reader of the others.
struct Lessons {
  std::vector<Executor> executors{shipped_maps().begin(), shipped_maps().end()};
  TrainOptions options;
  Examples examples;
  std::vector<const Example*> heard;
  Grounder reader;
  Dilemmas dilemmas;

  Lessons() {
    const Corpus corpus =
        generate_corpus(shipped_maps(), {.seed = 3, .paragraphs = testing::scaled(60), .sentences = 4});
    examples = make_examples(corpus, executors, Convention::Absolute);
    find_programs(examples.sentences, executors, PostfixGrammar(shipped_maps().front().vocabulary()), 1,
                  [](double) { return true; });
    options.epochs = 1;
    std::vector<const Example*> others;
    for (const Example& example : examples.sentences) (example.map == 2 ? heard : others).push_back(&example);
    reader = learn_reader(others, executors, options, [](double) {});
    add_dilemmas(reader, heard, executors, options, dilemmas);
  }
};

const Lessons& lessons() {
  static const Lessons lessons;
  return lessons;
}

TEST(LearnChooser, OfEndsTheGoldOneIsRightOfStartsTheGoldOne) {
  ASSERT_FALSE(lessons().dilemmas.of_ends.empty());
  ASSERT_FALSE(lessons().dilemmas.of_starts.empty());
  for (const Dilemma& dilemma : lessons().dilemmas.of_ends) {
    ASSERT_EQ(dilemma.right.size(), 1U);
    for (std::size_t i = 0; i < dilemma.options.size(); ++i) {
      EXPECT_EQ(dilemma.options[i].start, dilemma.example->gold.start);
      EXPECT_EQ(dilemma.options[i].plan.end == dilemma.example->gold.end, i == dilemma.right.front());
    }
  }
  for (const Dilemma& dilemma : lessons().dilemmas.of_starts) {
    ASSERT_LT(dilemma.right.size(), dilemma.options.size());
    for (std::size_t i = 0; i < dilemma.options.size(); ++i)
      EXPECT_EQ(dilemma.options[i].start == dilemma.example->gold.start,
                std::binary_search(dilemma.right.begin(), dilemma.right.end(), i));
  }
}

// Sentences that begin a paragraph, or begin elsewhere than where the last one ended, say nothing about starts.
TEST(LearnChooser, StartsAreAskedForOnlyWhereAParagraphGoesOn) {
  for (const Dilemma& dilemma : lessons().dilemmas.of_starts) {
    const Example& example = *dilemma.example;
    const auto it = std::find(lessons().heard.begin(), lessons().heard.end(), &example);
    ASSERT_NE(it, lessons().heard.begin());
    const Example& before = **(it - 1);
    EXPECT_EQ(before.paragraph, example.paragraph);
    EXPECT_EQ(before.position + 1, example.position);
    EXPECT_EQ(before.gold.end, example.gold.start);
  }
}

// log p(right) of a table, by the definition; mean over dilemmas.
double log_likelihood(const LinearModel& model, const WeightTable& table,
                      const std::vector<Dilemma>& dilemmas) {
  double sum = 0;
  for (const Dilemma& dilemma : dilemmas) {
    ChooserSentence sentence(model, dilemma.example->input);
    for (const Dilemma::Option& option : dilemma.options)
      sentence.add_end(lessons().executors[dilemma.example->map], option.start, option.plan, option.mass);
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
      if (std::binary_search(dilemma.right.begin(), dilemma.right.end(), i)) right += std::exp(score);
    }
    sum += std::log(right / all);
  }
  return sum / static_cast<double>(dilemmas.size());
}

TEST(LearnChooser, WhatIsRightBecomesLikelier) {
  const auto learned = [&](int epochs) {
    TrainOptions options = lessons().options;
    options.chooser_epochs = epochs;
    return with_chooser(lessons().reader, lessons().dilemmas, lessons().executors, options, [](double) {});
  };
  const Grounder before = learned(0), after = learned(6);
  const auto gain = [&](const WeightTable LinearModel::*table, const std::vector<Dilemma>& dilemmas) {
    return log_likelihood(*after.model, (*after.model).*table, dilemmas) -
           log_likelihood(*before.model, (*before.model).*table, dilemmas);
  };
  EXPECT_GT(gain(&LinearModel::chooser, lessons().dilemmas.of_ends), 0.1);
  EXPECT_GT(gain(&LinearModel::locator, lessons().dilemmas.of_starts), 0.1);
  // Each from its own dilemmas: the chooser is the worse locator.
  EXPECT_GT(log_likelihood(*after.model, after.model->locator, lessons().dilemmas.of_starts),
            log_likelihood(*after.model, after.model->chooser, lessons().dilemmas.of_starts));
}

}  // namespace
}  // namespace waymark::parser
