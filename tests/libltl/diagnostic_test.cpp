#include "libltl/diagnostic.hpp"

#include <gtest/gtest.h>

#include <string>

namespace waymark::ltl {
namespace {

TEST(SyntaxError, PutsTheCaretUnderTheCharacterNotTheByte) {
  const SyntaxError error("◇ché & ◇", {8, 9}, "expected better", "tour.ltl", 7);
  EXPECT_EQ(error.column(), 6U);
  EXPECT_EQ(error.line(), 7U);
  EXPECT_STREQ(error.what(),
               "expected better\n"
               "  tour.ltl:7:6\n"
               "  7 | ◇ché & ◇\n"
               "    |      ^");
}

TEST(SyntaxError, ShowsTheLineThatItIsAbout) {
  const std::string text = "a &\n\tb |\nc";
  const SyntaxError error(text, {5, 6}, "expected an end");
  EXPECT_EQ(error.line(), 2U);
  EXPECT_STREQ(error.what(),
               "expected an end\n"
               "  2 |  b |\n"
               "    |  ^");
  EXPECT_STREQ(error.in("f", 10).what(),
               "expected an end\n"
               "  f:11:2\n"
               "  11 |  b |\n"
               "     |  ^");
}

TEST(SyntaxError, SpansAreUnderlinedAsFarAsTheLineGoes) {
  EXPECT_STREQ(SyntaxError("ab cd", {3, 5}, "m").what(), "m\n  1 | ab cd\n    |    ^^");
  EXPECT_STREQ(SyntaxError("ab", {2, 2}, "m").what(), "m\n  1 | ab\n    |   ^");
  EXPECT_STREQ(SyntaxError("", {0, 0}, "m").what(), "m\n  1 | \n    | ^");
}

TEST(FormatError, NamesThePlaceAsFarAsItIsKnown) {
  EXPECT_STREQ(FormatError("map.json", 3, 5, "expected a node").what(), "expected a node\n  map.json:3:5");
  EXPECT_STREQ(FormatError("map.json", 3, 0, "expected a node").what(), "expected a node\n  map.json:3");
  EXPECT_STREQ(FormatError("map.json", 0, 0, "expected a map").what(), "expected a map\n  map.json");
  EXPECT_STREQ(FormatError("", 0, 0, "expected a map").what(), "expected a map");
  EXPECT_STREQ(FormatError("", 2, 1, "expected a map").what(), "expected a map\n  input:2:1");
}

TEST(Utf8, CountsCharacters) {
  EXPECT_EQ(utf8_length("◇aé𝒰"), 4U);
  EXPECT_EQ(utf8_length("\xC3"), 1U);
}

}  // namespace
}  // namespace waymark::ltl
