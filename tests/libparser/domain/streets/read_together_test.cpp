#include "libparser/domain/streets/read_together.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace waymark::streets {
namespace {

StreetReading reading(StreetRoute route, double probability) {
  StreetReading r;
  r.route.landmarks = std::move(route);
  r.probability = probability;
  return r;
}

using Texts = std::vector<std::vector<StreetReading>>;

TEST(ReadTogether, OneTextKeepsItsOrder) {
  const Texts texts{{reading({0, 1}, 0.6), reading({0, 2}, 0.3), reading({0, 1, 2}, 0.1)}};
  const auto together = read_together(texts);
  ASSERT_EQ(together.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(together[i].route.landmarks, texts[0][i].route.landmarks);
  EXPECT_TRUE(read_together({}).empty());
  EXPECT_TRUE(read_together(Texts(2)).empty());
}

TEST(ReadTogether, WhatOneLeavesOpenAnotherMaySay) {
  // Neither text has 0 1 2 first; both allow it.
  const Texts texts{{reading({0, 2}, 0.5), reading({0, 1, 2}, 0.4), reading({0, 3}, 0.1)},
                    {reading({0, 1}, 0.5), reading({0, 1, 2}, 0.4), reading({0, 3}, 0.1)}};
  EXPECT_EQ(read_together(texts).front().route.landmarks, (StreetRoute{0, 1, 2}));
}

TEST(ReadTogether, AHeedlessTextDoesNotOverruleTwo) {
  const Texts texts{{reading({0, 1}, 0.9), reading({0, 2}, 0.1)},
                    {reading({0, 1}, 0.9), reading({0, 2}, 0.1)},
                    {reading({0, 3}, 1.0)}};
  EXPECT_EQ(read_together(texts).front().route.landmarks, (StreetRoute{0, 1}));
}

// The posterior by its definition: every text is heedful or heedless, all ways in which that can be summed up.
std::map<StreetRoute, double> by_definition(const Texts& texts, double heedless) {
  std::map<StreetRoute, double> sum;
  for (const auto& text : texts)
    for (const StreetReading& r : text) sum[r.route.landmarks] = 0;
  const auto n = static_cast<double>(sum.size());
  double total = 0;
  for (auto& [route, probability] : sum) {
    for (unsigned idle = 0; idle < 1U << texts.size(); ++idle) {
      double product = 1;
      for (std::size_t t = 0; t < texts.size(); ++t) {
        double said = 0;
        for (const StreetReading& r : texts[t])
          if (r.route.landmarks == route) said = r.probability;
        product *= (idle >> t & 1U) != 0 ? heedless / n : (1 - heedless) * said;
      }
      probability += product;
    }
    total += probability;
  }
  for (auto& [route, probability] : sum) probability /= total;
  return sum;
}

TEST(ReadTogether, IsThePosteriorOfTheMixture) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 200; ++round) {
    const double heedless = 0.05 + 0.9 * static_cast<double>(random() % 100) / 100;
    Texts texts(1 + random() % 4);
    for (auto& text : texts) {
      const auto n = 1 + static_cast<LandmarkIndex>(random() % 5);
      double sum = 0;
      for (LandmarkIndex i = 0; i < n; ++i) {
        text.push_back(reading({0, i + static_cast<LandmarkIndex>(random() % 2) * 10},
                               1 + static_cast<double>(random() % 9)));
        sum += text.back().probability;
      }
      for (StreetReading& r : text) r.probability /= sum;
    }
    const auto expected = by_definition(texts, heedless);
    const auto together = read_together(texts, heedless);
    ASSERT_EQ(together.size(), expected.size());
    for (std::size_t i = 0; i < together.size(); ++i) {
      EXPECT_NEAR(together[i].probability, expected.at(together[i].route.landmarks), 1e-9)
          << "round " << round;
      if (i > 0) {
        EXPECT_GE(together[i - 1].probability, together[i].probability);
      }
    }
  }
}

}  // namespace
}  // namespace waymark::streets
