#include "libparser/domain/streets/second_look.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace waymark::streets {
namespace {

StreetReading reading(StreetRoute route, double probability) {
  StreetReading r;
  r.route.landmarks = std::move(route);
  r.route.rank_share = 0.2;
  r.probability = probability;
  return r;
}

// A city in which each of a few routes is described by three texts: two say it, the third leaves it open between the route and
// others that nobody describes.
ReadCity thrice(std::uint64_t seed, std::size_t pictures) {
  std::mt19937_64 random(seed);
  ReadCity city;
  const auto any = [&] {
    const auto draw = [&] { return static_cast<LandmarkIndex>(1 + random() % 30); };
    return StreetRoute{0, draw(), draw()};
  };
  for (std::size_t i = 0; i < pictures; ++i) {
    const StreetRoute route = any();
    for (int text = 0; text < 3; ++text) {
      const double right = text < 2 ? 0.8 : 0.2;
      TextReadings readings{reading(route, right)};
      for (int other = 0; other < 3; ++other) {
        StreetRoute wrong = any();
        wrong.push_back(31);  // never the right one of another picture
        readings.push_back(reading(wrong, (1 - right) / 3));
      }
      std::stable_sort(readings.begin(), readings.end(), [](const StreetReading& a, const StreetReading& b) {
        return a.probability > b.probability;
      });
      city.texts.push_back(std::move(readings));
      city.right.push_back(route);
    }
  }
  return city;
}

double share_right(const ReadCity& city, const std::vector<TextReadings>& texts) {
  double right = 0;
  for (std::size_t t = 0; t < texts.size(); ++t)
    right += texts[t].front().route.landmarks == city.right[t] ? 1 : 0;
  return right / static_cast<double>(texts.size());
}

TEST(TransductiveReranking, OtherTextsDecideWhatOneLeavesOpen) {
  const std::array<ReadCity, 2> cities{thrice(1, 60), thrice(2, 60)};
  const ReadCity test = thrice(3, 60);
  const TransductiveReranking look = learn_second_look(cities);
  const auto again = look_again(look, test.texts);
  EXPECT_LT(share_right(test, test.texts), 0.7);
  EXPECT_GT(share_right(test, again), 0.95);
  for (const TextReadings& readings : again) {
    double sum = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      sum += readings[i].probability;
      EXPECT_LE(readings[i].probability, readings[i > 0 ? i - 1 : 0].probability);
    }
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

// Support is what it was in other cities: where a route that all texts half mean was never right, it is not believed.
TEST(TransductiveReranking, LearnsWhatSupportIsWorth) {
  const auto tempted = [](std::uint64_t seed) {
    ReadCity city = thrice(seed, 60);
    for (std::size_t t = 0; t < city.texts.size(); ++t)
      city.texts[t] = {reading({0, 99}, 0.6), reading(city.right[t], 0.3), reading({0, 98}, 0.1)};
    return city;
  };
  const std::array<ReadCity, 2> cities{tempted(1), tempted(2)};
  const ReadCity test = tempted(3);
  EXPECT_EQ(share_right(test, test.texts), 0);
  EXPECT_GT(share_right(test, look_again(learn_second_look(cities), test.texts)), 0.95);
}

// Two texts alike support each other; what a text itself says is no support for it.
TEST(TransductiveReranking, ATextDoesNotSupportItself) {
  const std::array<ReadCity, 1> cities{thrice(1, 60)};
  const TransductiveReranking look = learn_second_look(cities);
  const TextReadings open{reading({0, 1}, 0.6), reading({0, 2}, 0.4)};
  const std::vector<TextReadings> alone{open};
  const auto again = look_again(look, alone);
  // Neither has support, shares of ranks are equal: only the first reading is left to weigh.
  EXPECT_EQ(again[0][0].route.landmarks, (StreetRoute{0, 1}));
  const std::vector<TextReadings> helped{open, {reading({0, 2}, 0.9), reading({0, 3}, 0.1)}};
  const auto probability = [](const TextReadings& readings, const StreetRoute& route) {
    const auto at = std::find_if(readings.begin(), readings.end(),
                                 [&](const StreetReading& r) { return r.route.landmarks == route; });
    return at == readings.end() ? 0 : at->probability;
  };
  EXPECT_GT(probability(look_again(look, helped)[0], {0, 2}), probability(again[0], {0, 2}));
}

TEST(TransductiveReranking, WithoutWeightsNothingChanges) {
  const ReadCity city = thrice(5, 10);
  EXPECT_TRUE(learn_second_look({}).weights.empty());
  const auto again = look_again({}, city.texts);
  ASSERT_EQ(again.size(), city.texts.size());
  for (std::size_t t = 0; t < again.size(); ++t)
    for (std::size_t i = 0; i < again[t].size(); ++i) {
      EXPECT_EQ(again[t][i].route.landmarks, city.texts[t][i].route.landmarks);
      EXPECT_EQ(again[t][i].probability, city.texts[t][i].probability);
    }
  EXPECT_TRUE(look_again(learn_second_look(std::array<ReadCity, 1>{city}), {}).empty());
}

}  // namespace
}  // namespace waymark::streets
