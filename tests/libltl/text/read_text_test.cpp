// Texts that come in: lines as std::getline reads them, and the bounds.
#include "libltl/text/read_text.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::ltl {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  LineReader reader(in, "text");
  std::vector<std::string> out;
  for (std::string line; reader.next(line);) {
    out.push_back(line);
    EXPECT_EQ(reader.number(), out.size());
  }
  return out;
}

TEST(LineReader, ReadsWhatGetlineReads) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    std::string text;
    const std::size_t lines = random() % 6;
    for (std::size_t k = 0; k < lines; ++k) {
      // Around the size of a block, too.
      const std::size_t length = random() % 3 == 0 ? 4090 + random() % 10 : random() % 20;
      text += std::string(length, static_cast<char>('a' + random() % 3));
      if (k + 1 < lines || random() % 2 == 0) text += '\n';
    }
    std::istringstream in(text);
    std::vector<std::string> wanted;
    for (std::string line; std::getline(in, line);) wanted.push_back(line);
    ASSERT_EQ(lines_of(text), wanted) << "trial " << i;
  }
}

TEST(LineReader, DropsByteOrderMarksAndReturns) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a\r\n\r\nb\r"),
            (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(lines_of(std::string("a\0b\n", 4)), (std::vector<std::string>{std::string("a\0b", 3)}));
}

TEST(LineReader, StopsAtALineThatIsTooLong) {
  std::istringstream in("a\n" + std::string(most_line_bytes + 1, 'x') + "\nb\n");
  LineReader reader(in, "text");
  std::string line;
  EXPECT_TRUE(reader.next(line));
  try {
    reader.next(line);
    ADD_FAILURE() << "a line of any length";
  } catch (const FormatError& error) {
    EXPECT_EQ(error.line(), 2U) << error.what();
  }
  EXPECT_FALSE(reader.next(line));
}

TEST(ReadText, HasABound) {
  std::istringstream small(
      "\xEF\xBB\xBF"
      "abc"),
      large(std::string(11, 'x'));
  EXPECT_EQ(read_text(small, "small", 10), "abc");
  EXPECT_THROW(read_text(large, "large", 10), FormatError);
  EXPECT_THROW(read_text("/dev/zero", 1U << 20U), FormatError);
  EXPECT_THROW(read_text("."), FormatError);
}

}  // namespace
}  // namespace waymark::ltl
