#include "libplan/learn/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace waymark::plan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Statistics, Medians) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median({1, infinity, infinity, infinity}), infinity);
  EXPECT_EQ(median({1, 1, infinity}), 1);
}

// 8 of 10: the interval of [Wil27] as tables give it.
TEST(Statistics, WilsonIntervals) {
  const Estimate e = rate(8, 10);
  EXPECT_NEAR(e.value, 0.8, 1e-12);
  EXPECT_NEAR(e.low, 0.4902, 1e-4);
  EXPECT_NEAR(e.high, 0.9433, 1e-4);
  EXPECT_NEAR(rate(10, 10).high, 1, 1e-12);
  EXPECT_NEAR(rate(0, 10).low, 0, 1e-12);
}

// For the mean of many values the bootstrap is the normal interval.
TEST(Statistics, BootstrapOfAMean) {
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(i % 2);
  const Estimate e = bootstrap_mean(values);
  EXPECT_EQ(e.value, 0.5);
  EXPECT_NEAR(e.high - e.low, 2 * 1.96 * 0.5 / 20, 0.01);
  const Estimate again = bootstrap_mean(values);
  EXPECT_EQ(e.low, again.low);
  EXPECT_EQ(bootstrap_median({7, 7, 7}).low, 7);
}

}  // namespace
}  // namespace waymark::plan
