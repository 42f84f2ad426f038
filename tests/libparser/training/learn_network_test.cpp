#include "libparser/training/learn_network.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "libparser/experiment/action_network.hpp"
#include "libparser/model_file.hpp"
#include "libplan/world/trajectory.hpp"
#include "tests/libparser/training/instances.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

const Corpus& small_corpus() {
  static const Corpus corpus = training_corpus(testing::sanitized ? 4 : 10);
  return corpus;
}

TEST(LearnNetwork, SameSeedGivesTheSameBytesAtAnyNumberOfThreads) {
  const auto bytes = [](std::uint64_t seed, int threads) {
    TrainOptions options = small_options(1);
    options.seed = seed;
    options.threads = threads;
    options.explore_from = 0;
    options.reranker = true;
    options.reranker_epochs = 1;
    return serialize(train(small_corpus(), training_maps(), options));
  };
  const std::string one = bytes(1, 1);
  EXPECT_EQ(one, bytes(1, 3));
  EXPECT_NE(one, bytes(2, 1));
  // What is read back reads sentences alike, and writes the same bytes.
  const Grounder read = parse_grounder(one);
  EXPECT_EQ(serialize(read), one);
  for (std::size_t n = 0; n < one.size(); n += one.size() / 50)
    EXPECT_THROW(parse_grounder(one.substr(0, n)), ltl::FormatError);
}

TEST(LearnActions, AnswersAreRoutesOfTheMap) {
  const TrainingExamples on(small_corpus());
  const auto follower = learn_actions(on.all, on.executors, small_options(1), [](double) {});
  for (const Example* example : on.all) {
    const Response answer = follower->follow(on.executors[example->map], example->input, example->gold.start);
    const auto walked = plan::follow(on.executors[example->map].map(), example->gold.start, answer.actions);
    ASSERT_TRUE(walked.has_value());
    EXPECT_EQ(walked->poses.back(), answer.end);
    EXPECT_GT(answer.probability, 0);
    EXPECT_LE(answer.probability, 1 + 1e-6);
  }
}

}  // namespace
}  // namespace waymark::parser
