#include "libparser/domain/commands/evaluate_commands.hpp"

#include <gtest/gtest.h>

namespace waymark::parser {
namespace {

// Two bins: 0.9 said and half right, 0.1 said and never right; the mean of 0.4 and 0.1 over two answers each.
TEST(Calibration, IsTheMeanGapOfTheBins) {
  Calibration calibration;
  EXPECT_EQ(calibration.expected_error(), 0);
  for (const bool right : {true, false}) calibration.add(0.9, right);
  for (int i = 0; i < 2; ++i) calibration.add(0.1, false);
  EXPECT_NEAR(calibration.expected_error(), 0.25, 1e-12);
  calibration.add(1, true);  // the last bin holds certainty
  EXPECT_EQ(calibration.bins.back().n, 3U);
}

}  // namespace
}  // namespace waymark::parser
