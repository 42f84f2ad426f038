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

// Up to 60 characters before the place, 200 in all; "…" stands for what is left out.
TEST(SyntaxError, ShowsAPartOfALongLine) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += static_cast<char>('a' + i % 26);
  const auto expected = [&](std::size_t from, bool cut_left, bool cut_right, std::size_t spaces) {
    return "m\n  1 | " + std::string(cut_left ? "…" : "") + text.substr(from, 200) + (cut_right ? "…" : "") +
           "\n    | " + std::string(spaces, ' ') + "^";
  };
  EXPECT_EQ(SyntaxError(text, {150, 151}, "m").what(), expected(90, true, true, 61));
  EXPECT_EQ(SyntaxError(text, {61, 62}, "m").what(), expected(1, true, true, 61));
  EXPECT_EQ(SyntaxError(text, {60, 61}, "m").what(), expected(0, false, true, 60));
  EXPECT_EQ(SyntaxError(text, {10, 11}, "m").what(), expected(0, false, true, 10));
  EXPECT_EQ(SyntaxError(text, {160, 161}, "m").what(), expected(100, true, false, 61));
  EXPECT_EQ(SyntaxError(text, {299, 300}, "m").what(), expected(239, true, false, 61));
  const std::string long_span = SyntaxError(text, {150, 300}, "m").what();
  EXPECT_EQ(long_span, expected(90, true, true, 61) + std::string(140, '^')) << "as far as the line is shown, and …";
  text.resize(200);
  EXPECT_EQ(SyntaxError(text, {150, 151}, "m").what(), expected(0, false, false, 150));
}

TEST(SyntaxError, ShowsControlCharactersAsSpaces) {
  EXPECT_STREQ(SyntaxError("a\x01\x1F\x7F b", {4, 5}, "m").what(), "m\n  1 | a    b\n    |     ^");
}

TEST(SyntaxError, ShowsInvalidBytesAsOneCharacterEach) {
  EXPECT_STREQ(SyntaxError("\x80é\xC3 \xC2\x9B b", {8, 9}, "m").what(), "m\n  1 | \uFFFDé\uFFFD   b\n    |       ^");
}

TEST(Diagnostics, ShowNoByteThatSteersATerminal) {
  EXPECT_STREQ(FormatError("\x1B]0;f\a", 0, 0, "no map is called '\x1B[31m\xFF'").what(),
               "no map is called '\\x1B[31m\\xFF'\n  \\x1B]0;f\\x07");
  EXPECT_STREQ(SyntaxError("a", {0, 1}, std::string_view("\0'\r'", 4), "\t").what(),
               "\\x00'\\x0D'\n  \\x09:1:1\n  1 | a\n    | ^");
}

TEST(Printable, KeepsCharactersAndLineEnds) {
  const std::string kept = "◇ché 𝒰\nline ~ \\x1B";
  EXPECT_EQ(printable(kept), kept);
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  const std::string once = printable(all);
  EXPECT_EQ(printable(once), once);
  EXPECT_EQ(utf8_length(once), once.size());
  EXPECT_EQ(printable("\xC2\x9B\xC2\xA0\xED\xA0\x80\xE2\x97"), "\\xC2\\x9B\xC2\xA0\\xED\\xA0\\x80\\xE2\\x97");
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
  EXPECT_EQ(utf8_length("\x80\x80"), 2U);
  EXPECT_EQ(utf8_character("", 0), 0U);
  EXPECT_EQ(utf8_character("a◇", 1), 3U);
  EXPECT_EQ(utf8_character("a◇", 2), 0U);
}

}  // namespace
}  // namespace waymark::ltl
