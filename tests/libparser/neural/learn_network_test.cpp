#include "libparser/neural/learn_network.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "libparser/generate.hpp"
#include "libparser/neural/action_network.hpp"
#include "libparser/weights_file.hpp"
#include "libplan/world/trajectory.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

const Corpus& lessons() {  // on grid and jelly
  static const Corpus corpus =
      generate_corpus(std::span(shipped_maps()).first(2), {.seed = 1, .paragraphs = 10, .sentences = 4});
  return corpus;
}

TrainOptions options_of(int epochs) {
  TrainOptions options;
  options.reader = ReaderKind::EncoderDecoder;
  options.network.epochs = epochs;
  options.network.sizes = {.word = 16, .width = 16, .query = 24, .symbol = 12, .history = 4};
  options.chooser = false;
  options.beam = 16;
  return options;
}

TEST(LearnNetwork, SameSeedGivesTheSameBytesAtAnyNumberOfThreads) {
  const auto bytes = [](std::uint64_t seed, int threads) {
    TrainOptions options = options_of(1);
    options.seed = seed;
    options.threads = threads;
    options.explore_from = 0;
    options.chooser = true;
    options.chooser_epochs = 1;
    return serialize(train(lessons(), std::span(shipped_maps()).first(2), options));
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
  const std::vector<Executor> executors(shipped_maps().begin(), shipped_maps().end());
  const Examples examples = make_examples(lessons(), executors, Convention::Absolute);
  std::vector<const Example*> all;
  for (const Example& example : examples.sentences) all.push_back(&example);
  const auto follower = learn_actions(all, executors, options_of(1), [](double) {});
  for (const Example* example : all) {
    const Answer answer = follower->follow(executors[example->map], example->input, example->gold.start);
    const auto walked = plan::follow(executors[example->map].map(), example->gold.start, answer.actions);
    ASSERT_TRUE(walked.has_value());
    EXPECT_EQ(walked->poses.back(), answer.end);
    EXPECT_GT(answer.probability, 0);
    EXPECT_LE(answer.probability, 1 + 1e-6);
  }
}

}  // namespace
}  // namespace waymark::parser
