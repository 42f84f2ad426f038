#include "libparser/rerank/ranker.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace waymark::parser {
namespace {

TEST(Ranker, AScoreIsTheSumOfWeightedFeaturesOfAllBundles) {
  WeightTable weights(1);
  *weights.row(weights.add(10)) = 0.5F;
  *weights.row(weights.add(20)) = -2.0F;
  // The feature 30 has no weight; the second candidate has the first bundle twice.
  const CandidateFeatures features{{{{10, 1}, {20, 0.25F}}, {{20, 3}, {30, 7}}}, {{0, 1}, {0, 0}, {}}};
  EXPECT_EQ(scores(weights, features), (std::vector<double>{-6.0, 0.0, 0.0}));
}

TEST(Ranker, ProbabilitiesSumToOneHoweverLargeTheScores) {
  std::vector<double> p{1000, 1000 + std::log(3.0), -1000};
  EXPECT_NEAR(normalise(p), 1000 + std::log(4.0), 1e-9);
  EXPECT_NEAR(p[0], 0.25, 1e-12);
  EXPECT_NEAR(p[1], 0.75, 1e-12);
  EXPECT_EQ(p[2], 0.0);
}

}  // namespace
}  // namespace waymark::parser
