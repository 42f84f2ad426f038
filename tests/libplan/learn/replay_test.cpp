#include "libplan/learn/replay.hpp"

#include <gtest/gtest.h>

#include <set>

namespace waymark::plan {
namespace {

TEST(Replay, KeepsTheLast) {
  Replay replay(3);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(replay.add({i}), i % 3);
  std::set<std::uint32_t> kept;
  for (std::size_t place = 0; place < replay.size(); ++place) kept.insert(replay[place].position);
  EXPECT_EQ(kept, (std::set<std::uint32_t>{2, 3, 4}));
}

TEST(Priorities, AreDrawnInProportion) {
  Priorities priorities(5);
  const std::vector<double> weights{1, 0, 4, 3, 2};
  for (std::size_t i = 0; i < weights.size(); ++i) priorities.set(i, 9);
  for (std::size_t i = 0; i < weights.size(); ++i) priorities.set(i, weights[i]);
  EXPECT_EQ(priorities.sum(), 10);
  EXPECT_EQ(priorities.greatest(), 9);
  ltl::Random random(2);
  std::vector<int> drawn(5, 0);
  constexpr int draws = 50'000;
  for (int i = 0; i < draws; ++i) ++drawn.at(priorities.draw(random));
  for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(drawn[i], draws * weights[i] / 10, 400) << i;
  EXPECT_EQ(drawn[1], 0);
}

}  // namespace
}  // namespace waymark::plan
