#include "libplan/world/letter_lines.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {
namespace {

TEST(LetterLines, ReadTheSameWordInEveryFormat) {
  const std::string word = "{a}; {a, b}; {}; {b}";
  for (const char* text :
       {"{a}\n{a, b}\n\n# a comment\n{}\n{b}\n", "a; a b; ; b", "[\"a\"]\n[\"a\",\"b\"]\n[]\n[\"b\"]",
        "{\"a\":true,\"b\":0}\n{\"a\":1,\"b\":true}\n{}\n{\"b\":true}\n", "a,b\n1,0\ntrue,1\n,\n0,TRUE\n",
        "\"a\", b\r\n1, 0\r\n1, 1\r\n0, 0\r\n0, 1\r\n"}) {
    const NamedTrace read = read_letters(text, LetterFormat::Auto, "t");
    EXPECT_EQ(ltl::show(read.word, read.vocabulary), word) << text;
  }
}

TEST(LetterLines, OnlyATableNamesAllPropositions) {
  EXPECT_TRUE(read_letters("a,b\n0,0\n", LetterFormat::Auto, "t").names_all);
  EXPECT_TRUE(read_letters("a\n0\n", LetterFormat::Csv, "t").names_all);
  EXPECT_FALSE(read_letters("a\n", LetterFormat::Auto, "t").names_all);
}

TEST(LetterLines, AnEmptyFirstLetterDoesNotSettleTheFormat) {
  const NamedTrace read = read_letters("{}\n{a}\n", LetterFormat::Auto, "t");
  EXPECT_EQ(ltl::show(read.word, read.vocabulary), "{}; {a}");
}

TEST(LetterLines, KeepTheVocabularyTheyWereGiven) {
  LetterLines lines(ltl::Vocabulary({"p", "q"}), LetterFormat::Text, "t");
  for (int i = 0; i < 10'000; ++i) lines.read("{other" + std::to_string(i) + "}");
  EXPECT_LT(lines.vocabulary().size(), 6'000U);
  EXPECT_EQ(lines.read("{q}").front(), ltl::Letter({ltl::Proposition{1}}));
}

TEST(LetterLines, SayWhichLineIsWrong) {
  const struct {
    const char *text, *message;
  } rows[] = {
      {"{a}\n{b", "t:2:3"},
      {"a,b\n1,0\n1\n", "the row has 1 cells, the header 2"},
      {"a,b\n1,2\n", "not '2'"},
      {"a,,b\n", "a column without a name"},
      {"[\"a\"]\n{\"a\":2}\n", "expected true, false, 1 or 0"},
      {"[\"a\"]\n{\"[\":2}\n", "expected true, false, 1 or 0"},
      {"[\"a\"]\n7\n", "expected a list of names"},
      {"{a}\n({b})w\n", "not the cycle of a lasso"},
      {"# nothing\n", "there are no letters"},
  };
  for (const auto& row : rows) {
    std::string message;
    try {
      read_letters(row.text, LetterFormat::Auto, "t");
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_NE(message.find(row.message), std::string::npos) << row.text << ": " << message;
  }
}

}  // namespace
}  // namespace waymark::plan
