#include "libparser/model/features.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/model/weight_table.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

const std::vector<std::uint64_t>& context(const SentenceFeatures& f, std::size_t kind, std::size_t step) {
  return f.by_context[kind][step];
}

std::size_t common(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  return static_cast<std::size_t>(std::count_if(
      a.begin(), a.end(), [&](std::uint64_t key) { return std::find(b.begin(), b.end(), key) != b.end(); }));
}

TEST(Features, AStepSharesTheFeaturesOfItsClauseWithTheSameWordsElsewhere) {
  WordTable words;
  const auto two = sentence_features({tokenize("walk to the chair and turn left"), false}, words);
  const auto one = sentence_features({tokenize("turn left"), false}, words);
  // The second step of the first sentence sees what the first step of the second sees: "turn", "left", and the pairs
  // <s> turn, turn left, left </s>; and "one clause left".
  EXPECT_GE(common(context(two, 0, 1), context(one, 0, 0)), 5U);
  EXPECT_LT(common(context(two, 0, 0), context(one, 0, 0)), common(context(two, 0, 1), context(one, 0, 0)) + 6);
}

TEST(Features, UnknownWordsAreLeftOutWhenDecoding) {
  WordTable words;
  sentence_features({tokenize("turn left"), false}, words);
  const WordTable& known = words;
  const std::size_t size = words.words().size();
  const auto f = sentence_features({tokenize("turn xyzzy"), false}, known);
  EXPECT_EQ(words.words().size(), size);
  EXPECT_FALSE(context(f, 0, 0).empty());
}

TEST(Features, AnUnknownHeadingIsSeen) {
  WordTable words;
  const auto open = sentence_features({tokenize("walk on"), true}, words);
  const auto known = sentence_features({tokenize("walk on"), false}, words);
  EXPECT_NE(context(open, 0, 0), context(known, 0, 0));
}

TEST(Features, PlacesAreForbiddenUnlessTheSentenceNamesTheirNumber) {
  const ltl::Vocabulary& vocabulary = shipped_maps().front().vocabulary();
  const ProgramLanguage language(vocabulary);
  WordTable words;
  const auto forbids = [&](const char* text, const char* literal) -> bool {
    const auto f = sentence_features({tokenize(text), false}, words);
    const auto p = static_cast<std::uint16_t>(vocabulary.find(literal).value().index);
    return forbidden_tokens(language, f)[PostfixGrammar::literal(p)];
  };
  EXPECT_TRUE(forbids("this is it", "place_4"));
  EXPECT_FALSE(forbids("this is position 4", "place_4"));
  EXPECT_FALSE(forbids("position four is here", "place_4"));
  EXPECT_TRUE(forbids("this is position 4", "place_5"));
  EXPECT_FALSE(forbids("this is it", "chair"));
  EXPECT_TRUE(forbids("this is it", "moved"));
}

TEST(Features, ModelsOfAnotherVocabularyAreRefusedByName) {
  const ProgramLanguage model(ltl::Vocabulary({"chair", "moved"}));
  EXPECT_NO_THROW(model.check_vocabulary(ltl::Vocabulary({"chair", "moved"}), "the map"));
  const std::pair<std::vector<std::string>, const char*> table[] = {
      {{"moved"}, "'chair' is missing"},
      {{"chair", "moved", "sofa"}, "does not know 'sofa'"},
      {{"moved", "chair"}, "another order"},
  };
  for (const auto& [names, message] : table) {
    try {
      model.check_vocabulary(ltl::Vocabulary(names), "the map");
      ADD_FAILURE() << message;
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

TEST(WeightTable, FindsWhatWasAddedAfterGrowth) {
  WeightTable table(3);
  for (std::uint64_t f = 0; f < 5000; ++f) table.row(table.add(f * 0x100000001ULL))[1] = static_cast<float>(f);
  EXPECT_EQ(table.rows(), 5000U);
  for (std::uint64_t f = 0; f < 5000; ++f)
    ASSERT_EQ(table.row(table.find(f * 0x100000001ULL).value())[1], static_cast<float>(f));
  EXPECT_FALSE(table.find(17));
}

}  // namespace
}  // namespace waymark::parser
