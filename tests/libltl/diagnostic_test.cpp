#include "libltl/diagnostic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

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

// The same of characters of one to four bytes, told by their numbers: every place in lines around the longest.
TEST(SyntaxError, CutsLongLinesBetweenCharacters) {
  const std::vector<std::string> alphabet{"a", "é", "◇", "𝒰", "z", "\uFFFD"};
  for (const std::size_t length : {199U, 200U, 201U, 259U, 260U, 261U, 330U}) {
    std::vector<std::string> characters;
    std::string text = "one ◇ before\n";
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < length; ++i) {
      characters.push_back(alphabet[(i * i + i / 7) % alphabet.size()]);
      begins.push_back(text.size());
      text += characters.back();
    }
    begins.push_back(text.size());
    text += "\none 𝒰 after";
    for (std::size_t at = 0; at < length; ++at) {
      const std::size_t first = length <= 200 || at < 60 ? 0 : at - 60;
      const std::size_t last = length <= 200 ? length : std::min(length, first + 200);
      for (const std::size_t wide : {1U, 3U}) {
        std::string expected = "m\n  2 | ";
        if (first > 0) expected += "…";
        for (std::size_t i = first; i < last; ++i) expected += characters[i];
        if (last < length) expected += "…";
        const std::size_t until = std::min(at + wide, length);
        expected += "\n    | " + std::string(at - first + (first > 0 ? 1 : 0), ' ') + std::string(until - at, '^');
        ASSERT_EQ(SyntaxError(text, {begins[at], begins[until]}, "m").what(), expected)
            << length << " characters, at " << at;
      }
    }
  }
}

TEST(Diagnostics, ShowAThousandCharactersOfAMessage) {
  for (const std::string character : {"a", "é", "◇", "𝒰"}) {
    std::string message;
    for (int i = 0; i < 1'000; ++i) message += character;
    EXPECT_EQ(FormatError("", 0, 0, message).what(), message);
    EXPECT_EQ(FormatError("", 0, 0, message + character).what(), message + "…");
    EXPECT_EQ(FormatError("", 0, 0, message + message).what(), message + "…");
  }
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

// The bytes of a code point, from the definition of UTF-8.
std::string encoded(std::uint32_t point) {
  const auto six = [&](unsigned shift) { return static_cast<char>(0x80U | ((point >> shift) & 0x3FU)); };
  if (point < 0x80) return {static_cast<char>(point)};
  if (point < 0x800) return {static_cast<char>(0xC0U | point >> 6U), six(0)};
  if (point < 0x10000) return {static_cast<char>(0xE0U | point >> 12U), six(6), six(0)};
  return {static_cast<char>(0xF0U | point >> 18U), six(12), six(6), six(0)};
}

bool is_encoded_point(std::string_view text) {
  std::uint32_t point = static_cast<unsigned char>(text[0]) & (0x7FU >> text.size());
  for (const char c : text.substr(1)) point = point << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  return point < 0x110000 && (point < 0xD800 || point > 0xDFFF) && encoded(point) == text;
}

// All code points; of four bytes those that differ in the first two, or in the others around the limits.
TEST(Utf8, CharactersAreTheEncodedCodePoints) {
  for (std::uint32_t point = 0; point < 0x110000; ++point) {
    const std::string text = encoded(point);
    const bool is_surrogate = point >= 0xD800 && point <= 0xDFFF;
    ASSERT_EQ(utf8_character(text, 0), is_surrogate ? 0 : text.size()) << point;
    ASSERT_EQ(utf8_character(std::string_view(text).substr(0, text.size() - 1), 0), 0U) << point;
  }
  const std::vector<int> around{0x00, 0x7F, 0x80, 0xBF, 0xC0, 0xFF};
  for (int first = 0x80; first < 0x100; ++first)
    for (int second = 0; second < 0x100; ++second)
      for (const int third : around)
        for (const int fourth : around) {
          const std::string text{static_cast<char>(first), static_cast<char>(second), static_cast<char>(third),
                                 static_cast<char>(fourth)};
          std::size_t expected = 0;
          for (std::size_t n = 2; n <= 4; ++n)
            if (is_encoded_point(std::string_view(text).substr(0, n))) expected = n;
          ASSERT_EQ(utf8_character(text, 0), expected) << printable(text);
        }
}

}  // namespace
}  // namespace waymark::ltl
