#include "libltl/word.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace waymark::ltl {
namespace {

TEST(Letter, IsASetOverManyBlocks) {
  Letter letter;
  for (std::uint32_t p : {0U, 63U, 64U, 130U}) letter.insert({p});
  EXPECT_EQ(letter.members(), (std::vector<Proposition>{{0}, {63}, {64}, {130}}));
  EXPECT_TRUE(letter.contains({130}));
  EXPECT_FALSE(letter.contains({129}));
  EXPECT_FALSE(letter.contains({5'000}));
  EXPECT_EQ(letter.block(2), std::uint64_t{1} << 2U);
  letter.erase({130});
  EXPECT_EQ(letter, (Letter{{0}, {63}, {64}}));  // equal sets are equal, whatever was in them before
  letter.erase({64});
  letter.erase({900});
  EXPECT_EQ(letter, (Letter{{0}, {63}}));
}

TEST(Letter, IncludesAndJoins) {
  const Letter small{{1}}, large{{1}, {70}};
  EXPECT_TRUE(large.includes(small));
  EXPECT_FALSE(small.includes(large));
  EXPECT_TRUE(small.includes(Letter{}));
  Letter joined = small;
  joined.insert_all(Letter{{70}});
  EXPECT_EQ(joined, large);
  joined.insert_all(Letter{{2}, {140}, {200}});
  EXPECT_EQ(joined.members(), (std::vector<Proposition>{{1}, {2}, {70}, {140}, {200}}));
  joined.insert_all(Letter{{71}});
  EXPECT_EQ(joined.members(), (std::vector<Proposition>{{1}, {2}, {70}, {71}, {140}, {200}}));
  EXPECT_TRUE(joined.includes(Letter{{71}, {200}}));
  EXPECT_FALSE(joined.includes(Letter{{71}, {201}}));
  EXPECT_FALSE(joined.includes(Letter{{72}}));
}

TEST(Words, AreNotEmpty) {
  EXPECT_THROW(Trace({}), std::invalid_argument);
  EXPECT_THROW(Lasso({Letter{}}, {}), std::invalid_argument);
  EXPECT_EQ(Lasso({}, {Letter{}}).loop_start(), 0U);
}

TEST(Lasso, GoesRoundItsCycle) {
  const Lasso word({Letter{}}, {Letter{{0}}, Letter{{1}}});
  EXPECT_EQ(word.successor(0), 1U);
  EXPECT_EQ(word.successor(1), 2U);
  EXPECT_EQ(word.successor(2), 1U);
}

TEST(Words, AreShownReadyToPaste) {
  const Vocabulary names({"a", "b"});
  EXPECT_EQ(show(Trace({Letter{{0}, {1}}, Letter{}}), names), "{a, b}; {}");
  EXPECT_EQ(show(Lasso({Letter{{0}}}, {Letter{}, Letter{{1}}}), names), "{a}; ({}; {b})ʷ");
}

}  // namespace
}  // namespace waymark::ltl
