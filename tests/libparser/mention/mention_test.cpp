#include "libparser/mention/mention.hpp"

#include <gtest/gtest.h>

#include "libparser/corpus/token.hpp"
#include "tests/libparser/lifted/few_words.hpp"

namespace waymark::parser {
namespace {

const std::vector<NamedThing> things{
    {"sofa", {{"sofa"}, {"couch"}}}, {"lamp", {{"lamp"}}}, {"floor_lamp", {{"floor", "lamp"}}}, {"easel", {{"easel"}}}};

std::string lifted(const std::string& text, const WordVectors* words = nullptr, Articles articles = Articles::Go) {
  const auto tokens = tokenize(text);
  std::string out;
  for (const std::string& token : lift(tokens, find_mentions(tokens, things, words), articles).text.tokens)
    out += (out.empty() ? "" : " ") + token;
  return out;
}

TEST(Mentions, AreTheLongestPhrasesAndBecomeSlotsInOrderOfFirstMention) {
  EXPECT_EQ(lifted("go to the floor lamp, then a couch and the sofa"), "go to #1 , then #2 and #2");
  EXPECT_EQ(lifted("go to the lamps and back to the lamp"), "go to #1 and back to #1");
  EXPECT_EQ(lifted("the lamp", nullptr, Articles::Stay), "the #1");
  EXPECT_EQ(lifted("nothing is named here"), "nothing is named here");
  const auto tokens = tokenize("a couch by the easel");
  const LiftedMentions out = lift(tokens, find_mentions(tokens, things));
  EXPECT_EQ(out.things, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(out.text.scope.slots, 2U);
}

TEST(Mentions, TiesGoToTheThingThatStandsFirst) {
  const std::vector<NamedThing> twins{
      {"lamp_1", {{"lamp"}}}, {"lamp_2", {{"floor", "lamp"}, {"lamp"}}}, {"lamp_3", {{"lamp"}, {"floor", "lamp"}}}};
  const auto found = find_mentions(tokenize("lamp floor lamp"), twins);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].thing, 0U);
  EXPECT_EQ(found[1].thing, 1U);
  EXPECT_EQ(found[1].begin, 1U);
  EXPECT_EQ(found[1].end, 3U);
}

TEST(Mentions, WordsOfFiveLettersMayBeMisspelledUnlessTheyAreWords) {
  EXPECT_EQ(lifted("to the easle"), "to #1");
  EXPECT_EQ(lifted("to the lamb"), "to the lamb");  // four letters
  EXPECT_EQ(lifted("to the measel"), "to #1");
  const MappedFile known{std::string_view(bytes_of_vectors({"measel"}))};
  const WordVectors vectors(known.bytes());
  EXPECT_EQ(lifted("to the measel", &vectors), "to the measel");
}

TEST(Misspellings, AreOneEditAway) {
  for (const char* word :
       {"chair", "chairs", "hair", "chiar", "cha1r", "xchair", "chai", "cair", "chait", "xhair", "hcair", "chari"})
    EXPECT_TRUE(is_misspelled(word, "chair")) << word;
  for (const char* word : {"hiar", "chaaair", "riach", "ahcri", "", "chaxy"})
    EXPECT_FALSE(is_misspelled(word, "chair")) << word;
}

TEST(Singulars, LoseOneS) {
  EXPECT_EQ(singular("lamps"), "lamp");
  EXPECT_EQ(singular("beds"), "bed");
  EXPECT_EQ(singular("grass"), "grass");
  EXPECT_EQ(singular("gas"), "gas");
}

TEST(Mentions, AreTwelveAtMost) {
  std::vector<NamedThing> many;
  std::vector<std::string> tokens;
  for (int i = 0; i < 14; ++i) {
    const std::string word = "x" + std::to_string(i);
    many.push_back({word, {{word}}});
    tokens.push_back(word);
  }
  const LiftedMentions out = lift(tokens, find_mentions(tokens, many));
  EXPECT_EQ(out.text.scope.slots, 12U);
  EXPECT_EQ(out.text.tokens.back(), "#12");
}

TEST(Mention, ANegatedMentionIsNotAndItsSlot) {
  const LiftedMentions lifted = lift({"keep", "the", "door", "shut", "now"}, {{2, 4, 0, true}});
  EXPECT_EQ(lifted.text.tokens, (std::vector<std::string>{"keep", "not", "#1", "now"}));
}

}  // namespace
}  // namespace waymark::parser
