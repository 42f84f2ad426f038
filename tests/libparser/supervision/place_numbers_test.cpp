#include "libparser/supervision/place_numbers.hpp"

#include <gtest/gtest.h>

#include "libparser/corpus/token.hpp"

namespace waymark::parser {
namespace {

std::vector<std::string> hidden(const std::string& text) { return without_place_numbers(tokenize(text)); }

TEST(PlaceNumbers, AreHidden) {
  EXPECT_EQ(hidden("here you find position 5."), tokenize("here you find position ."));
  EXPECT_EQ(hidden("Pos three comes next"), tokenize("pos comes next"));
  EXPECT_EQ(hidden("a postition 12"), tokenize("a postition"));
  EXPECT_EQ(hidden("walk on to p-3 now"), tokenize("walk on to now"));
  EXPECT_EQ(hidden("at six turn left"), tokenize("at turn left"));
  EXPECT_EQ(hidden("the end of this alley is 4"), tokenize("the end of this alley is"));
  EXPECT_EQ(hidden("4 has a lamp"), tokenize("has a lamp"));
}

TEST(PlaceNumbers, CountsStay) {
  for (const char* text : {"go forward 3", "walk two blocks", "the chair is two alleys away", "turn at one end",
                           "the other one is blue", "take the 2 steps, then 1 more"})
    EXPECT_EQ(hidden(text), tokenize(text));
}

TEST(PlaceNumbers, OfACorpusLeaveTheTokensOnly) {
  Corpus corpus;
  const std::string text = "this is position 2";
  corpus.paragraphs = {{"a", "grid", text, {{"1", text, tokenize(text), false, {}, {}, ""}}}};
  hide_place_numbers(corpus);
  EXPECT_EQ(corpus.paragraphs[0].sentences[0].text, text);
  EXPECT_EQ(corpus.paragraphs[0].sentences[0].tokens, tokenize("this is position"));
}

}  // namespace
}  // namespace waymark::parser
