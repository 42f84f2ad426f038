#include "libparser/training/learn.hpp"

#include <gtest/gtest.h>

#include "libparser/language/generate.hpp"
#include "libparser/model_file.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t own_paragraphs = testing::sanitized ? 10 : 30;

const Corpus& own_corpus() {
  static const Corpus corpus =
      generate_corpus(shipped_maps(), {.seed = 1, .paragraphs = own_paragraphs, .sentences = 4});
  return corpus;
}

TEST(Generate, TrajectoriesAreLegalAndSeedsDecide) {
  const std::vector<Executor> executors(shipped_maps().begin(), shipped_maps().end());
  EXPECT_EQ(make_examples(own_corpus(), executors, Convention::Absolute).sentences.size(), 4 * own_paragraphs);
  const auto text = [](std::uint64_t seed) {
    return generate_corpus(shipped_maps(), {.seed = seed, .paragraphs = 2, .sentences = 4}).paragraphs[1].text;
  };
  EXPECT_EQ(text(3), text(3));
  EXPECT_NE(text(3), text(4));
}

TEST(Learn, SameSeedGivesTheSameBytesAtAnyNumberOfThreads) {
  const auto bytes = [](std::uint64_t seed, int threads) {
    TrainOptions options;
    options.seed = seed;
    options.threads = threads;
    options.epochs = testing::sanitized ? 1 : 2;
    return serialize(train(own_corpus(), shipped_maps(), options));
  };
  const std::string one = bytes(1, 1);
  EXPECT_EQ(one, bytes(1, 3));
  EXPECT_NE(one, bytes(2, 1));
}

TEST(Learn, ReportsProgressThatNeverGoesBackAndStopsWhenAsked) {
  std::stop_source stop;
  TrainOptions options;
  double last = 0;
  std::size_t calls = 0;
  options.stop = stop.get_token();
  options.progress = [&](double fraction, std::string_view what) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    EXPECT_FALSE(what.empty());
    last = fraction;
    if (++calls == 20) stop.request_stop();
  };
  EXPECT_THROW(train(own_corpus(), shipped_maps(), options), Stopped);
  EXPECT_GE(calls, 20U);
}

TEST(Learn, InputsThatDoNotFitAreRefused) {
  EXPECT_THROW(train(own_corpus(), {}, {}), std::invalid_argument);
  EXPECT_THROW(train(Corpus{}, shipped_maps(), {}), std::invalid_argument);
  EXPECT_THROW(train(own_corpus(), std::span(shipped_maps()).first(1), {}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::parser
