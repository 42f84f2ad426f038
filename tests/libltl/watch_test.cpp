// Seconds and bytes as a stop: which limit is met, and that none is met by chance.
#include "libltl/watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace waymark::ltl {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20U;

void wait_for(const std::stop_token& token) {
  while (!token.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(Watch, StopsAfterItsSeconds) {
  const auto begin = std::chrono::steady_clock::now();
  const Watch watch({.seconds = 0.02}, {});
  wait_for(watch.token());
  EXPECT_EQ(watch.overrun(), Overrun::Time);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(20));
}

TEST(Watch, StopsWhenTheProcessHoldsTooMuch) {
  const Watch watch({.seconds = 600, .bytes = memory_held() + 64 * mebibyte}, {});
  EXPECT_FALSE(watch.token().stop_requested());
  const std::vector<char> held(96 * mebibyte, 'x');
  wait_for(watch.token());
  EXPECT_EQ(watch.overrun(), Overrun::Memory);
}

TEST(Watch, StopsForMemoryWithoutAnAllowanceOfSeconds) {
  const Watch watch({.bytes = 1}, {});
  wait_for(watch.token());
  EXPECT_EQ(watch.overrun(), Overrun::Memory);
}

TEST(Watch, ForwardsTheOtherStop) {
  std::stop_source other;
  const Watch watch({.seconds = 600, .bytes = SIZE_MAX}, other.get_token());
  EXPECT_FALSE(watch.token().stop_requested());
  other.request_stop();
  EXPECT_TRUE(watch.token().stop_requested());
  EXPECT_EQ(watch.overrun(), Overrun::None);
}

TEST(Watch, WithoutAnAllowanceItStopsForTheOtherOnly) {
  std::stop_source other;
  const Watch watch({}, other.get_token());
  EXPECT_FALSE(watch.token().stop_requested());
  other.request_stop();
  EXPECT_TRUE(watch.token().stop_requested());
}

TEST(Watch, MemoryHeldIsWhatWasTouched) {
  const std::size_t before = memory_held();
  const std::vector<char> held(64 * mebibyte, 'x');
  EXPECT_GE(memory_held(), before + 63 * mebibyte);
}

}  // namespace
}  // namespace waymark::ltl
