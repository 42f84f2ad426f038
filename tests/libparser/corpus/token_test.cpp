#include "libparser/corpus/token.hpp"

#include <gtest/gtest.h>

#include "libparser/lexicon/lexicon.hpp"

namespace waymark::parser {
namespace {

using Words = std::vector<std::string>;

TEST(Token, LowersSplitsApostrophesAndKeepsMarks) {
  const std::pair<const char*, Words> table[] = {
      {"Turn LEFT", {"turn", "left"}},
      {"it's the chair, isn't it?", {"it", "s", "the", "chair", ",", "is", "n't", "it", "?"}},
      {"the walls' end", {"the", "walls", "end"}},
      {"blue-tiled hall.", {"blue-tiled", "hall", "."}},
      {"(50%) \"here\"; there: now!", {"(", "50", "%", ")", "\"", "here", "\"", ";", "there", ":", "now", "!"}},
      {"  \t\n", {}},
      {"''", {}},
      {"n't", {"n't"}},
      {"does n't", {"does", "n't"}},  // split before, as navi has it
  };
  for (const auto& [text, words] : table) EXPECT_EQ(tokenize(text), words) << text;
}

TEST(Token, SentencesAreCutAfterMarks) {
  EXPECT_EQ(split_sentences("Go on. Turn left; stop!! Where?"), (Words{"Go on.", " Turn left;", " stop!", " Where?"}));
  EXPECT_EQ(split_sentences("walk on"), Words{"walk on"});
  EXPECT_EQ(split_sentences(" .;! "), Words{});
  EXPECT_EQ(split_sentences(""), Words{});
}

TEST(Token, MirrorExchangesLeftAndRightAndIsItsOwnInverse) {
  const Words words{"turn", "left", "at", "the", "right-hand", "wall"};
  EXPECT_EQ(mirror(words), (Words{"turn", "right", "at", "the", "left-hand", "wall"}));
  EXPECT_EQ(mirror(mirror(words)), words);
}

TEST(Lexicon, FindsOtherNamesPluralsCountsAndHyphens) {
  const std::pair<const char*, std::vector<Part>> table[] = {
      {"sit on the couch", {thing("sofa")}},
      {"two stools", {count(2), thing("2"), thing("barstool")}},
      {"the honeycomb-tiled hall", {thing("yellow")}},
      {"past the hat rack", {thing("hatrack")}},
      {"go straight", {}},
      {"the grass", {thing("grass")}},
  };
  for (const auto& [text, parts] : table) EXPECT_EQ(mentions(tokenize(text)), parts) << text;
}

TEST(Lexicon, NumbersAreReadInWordsAndDigits) {
  EXPECT_EQ(number_named("three"), 3U);
  EXPECT_EQ(number_named("twice"), 2U);
  EXPECT_EQ(number_named("12"), 12U);
  EXPECT_EQ(number_named("12th"), 0U);
  EXPECT_EQ(number_named("zero"), 0U);
  EXPECT_EQ(number_named("99999999999999999999999"), 0U);
}

TEST(Token, ClausesAreCutAtJointsAndMarks) {
  const auto clauses = [](const std::string& text) {
    const std::vector<std::string> tokens = tokenize(text);
    std::string out;
    for (const Clause& clause : clauses_of(tokens)) {
      for (std::size_t i = clause.begin; i < clause.end; ++i) out += tokens[i] + ' ';
      out += '|';
    }
    return out;
  };
  EXPECT_EQ(clauses("Turn left, and then walk on; go to the chair."), "turn left |walk on |go to the chair |");
  EXPECT_EQ(clauses("then turn"), "turn |");
  EXPECT_EQ(clauses("the sand, the band"), "the sand |the band |");
  EXPECT_EQ(clauses("and then,"), "and then , |");
  EXPECT_EQ(clauses(""), "|");
}

}  // namespace
}  // namespace waymark::parser
