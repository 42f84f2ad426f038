#include "libparser/experiment/tune.hpp"

#include <gtest/gtest.h>

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

TEST(Tune, OneMapIsNotEnough) {
  const auto one = std::span(shipped_maps()).first(1);
  const Corpus corpus = generate_corpus(one, {.seed = 1, .paragraphs = 2, .sentences = 2});
  EXPECT_THROW(validate(corpus, one, {}), std::invalid_argument);
}

}  // namespace
}  // namespace waymark::parser
