// Bounds in words contain the bounds: parsed again, none has moved inwards.
#include "tools/shell/rounded.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <random>

namespace waymark::tools {
namespace {

TEST(Rounded, BoundsMoveOutwardsOnly) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 100'000; ++i) {
    const double a = std::pow(10.0, exponent(random)), b = std::nextafter(a, INFINITY);
    const std::string text = between(a, b, 1 + i % 17);
    char* comma = nullptr;
    ASSERT_LE(std::strtod(text.c_str() + 4, &comma), a) << text;
    ASSERT_GE(std::strtod(comma + 2, nullptr), b) << text;
  }
}

TEST(Rounded, AreAsShortAsTheyCanBe) {
  EXPECT_EQ(between(0.25, 0.5), "in [0.25, 0.5]");
  EXPECT_EQ(between(1.0 / 3, 2.0 / 3, 4), "in [0.3333, 0.6667]");
  EXPECT_EQ(between(0, INFINITY), "in [0, inf]");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace
}  // namespace waymark::tools
