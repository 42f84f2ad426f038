#include "libparser/experiment/tune.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "libparser/language/generate.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

TEST(Tune, ValidatesOnEveryOrderedPairOfMaps) {
  const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 3, .paragraphs = 9, .sentences = 3});
  TrainOptions options;
  options.epochs = 1;
  const auto pairs = validate(corpus, shipped_maps(), options);
  ASSERT_EQ(pairs.size(), 6U);
  for (std::size_t left_out = 0; left_out < 3; ++left_out) {
    std::size_t hits = 0, total = 0;
    for (const ValidationPair& pair : pairs) {
      EXPECT_NE(pair.learned, pair.tested);
      EXPECT_EQ(pair.sentence.total, 9U);
      if (pair.learned == left_out || pair.tested == left_out) continue;
      hits += pair.sentence.hits;
      total += pair.sentence.total;
    }
    EXPECT_EQ(total, 18U);  // two pairs are left
    EXPECT_EQ(without_map(pairs, left_out).hits, hits);
    EXPECT_EQ(without_map(pairs, left_out).total, total);
  }
}

// Kept pairs are found again, the helper waits for nobody, and a part that is taken away is made anew.
TEST(Tune, GoesOnFromKeptPairs) {
  const auto directory = std::filesystem::temp_directory_path() / ("waymark-tune-" + std::to_string(::getpid()));
  const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 3, .paragraphs = 9, .sentences = 3});
  TrainOptions options;
  options.epochs = 1;
  const auto same = [&](const std::vector<ValidationPair>& a, const std::vector<ValidationPair>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].learned, b[i].learned);
      EXPECT_EQ(a[i].tested, b[i].tested);
      EXPECT_EQ(a[i].sentence.hits, b[i].sentence.hits);
      EXPECT_EQ(a[i].sentence.total, b[i].sentence.total);
    }
  };
  const auto whole = validate(corpus, shipped_maps(), options);
  const Checkpoints checkpoints(directory, "");
  const KeptPairs kept{&checkpoints, "setting "};
  {
    const std::string first = "setting " + shipped_maps()[0].name() + ".pairs";
    const auto claim = checkpoints.claim(first);  // somebody else makes it
    help_to_validate(corpus, shipped_maps(), options, kept);
    EXPECT_FALSE(checkpoints.has(first));
    EXPECT_TRUE(checkpoints.has("setting " + shipped_maps()[1].name() + ".pairs"));
  }
  same(validate(corpus, shipped_maps(), options, kept), whole);
  same(validate(corpus, shipped_maps(), options, kept), whole);
  std::filesystem::remove_all(directory);
}

TEST(Tune, OneMapIsNotEnough) {
  const auto one = std::span(shipped_maps()).first(1);
  const Corpus corpus = generate_corpus(one, {.seed = 1, .paragraphs = 2, .sentences = 2});
  EXPECT_THROW(validate(corpus, one, {}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::parser
