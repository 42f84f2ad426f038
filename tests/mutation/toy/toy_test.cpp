#include <gtest/gtest.h>

#include <cstddef>

namespace waymark::toy {
bool between(std::size_t low, std::size_t x, std::size_t high);
std::size_t doubled(std::size_t x);

TEST(Toy, IsBetween) {
  EXPECT_TRUE(between(2, 2, 4));
  EXPECT_TRUE(between(2, 3, 4));
  EXPECT_FALSE(between(2, 4, 4));
  EXPECT_FALSE(between(2, 1, 4));
  EXPECT_FALSE(between(2, 5, 4));
}

TEST(Toy, IsDoubled) { EXPECT_EQ(doubled(3), 6U); }

}  // namespace waymark::toy
