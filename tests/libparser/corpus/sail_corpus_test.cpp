#include "libparser/corpus/sail_corpus.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/supervision/examples.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

const std::string good = R"({"id":"a","map":"grid","text":"Stroll on. Stay put.","sentences":[)"
                         R"({"id":"1-1","text":"Stroll on","path":[[1,9,-1],[1,8,0]],)"
                         R"("path_north":[[1,9,0],[1,8,0]],"path_right90":[[1,9,270],[1,9,0],[1,8,0]]},)"
                         R"({"id":"1-2","text":"Stay put","tokens":["stay","put"],"path":[[1,8,0]]}]})";

TEST(SailCorpus, ReadsSentencesUnderBothConventions) {
  const auto paragraphs = parse_sail_corpus(good + "\n\n" + good + "\n");
  ASSERT_EQ(paragraphs.size(), 2U);
  const Sentence &first = paragraphs[0].sentences[0], &second = paragraphs[0].sentences[1];
  EXPECT_TRUE(first.heading_unknown);
  EXPECT_EQ(first.tokens, (std::vector<std::string>{"stroll", "on"}));
  EXPECT_EQ(first.path(Convention::Absolute).size(), 2U);
  EXPECT_EQ(first.path(Convention::Relative).size(), 3U);
  EXPECT_FALSE(second.heading_unknown);
  EXPECT_EQ(second.absolute, second.relative);
}

std::string replaced(const std::string& what, const std::string& by) {
  std::string text = good;
  return text.replace(text.find(what), what.size(), by);
}

TEST(SailCorpus, ErrorsNameTheLineAndTheValue) {
  const std::tuple<std::string, std::size_t, std::string> table[] = {
      {"{", 1, "malformed JSON"},
      {good + "\n[1]", 2, "expected an object"},
      {good + "\n{\"id\":1e999}", 2, "out of range"},
      {good + "\n" + replaced("\"map\":\"grid\"", "\"map\":7"), 2, "map: expected a text"},
      {replaced("\"map\":\"grid\",", ""), 1, "the key \"map\" is missing"},
      {replaced("[[1,8,0]]", "[[1,8,45]]"), 1, "sentences[1].path[0][2]: expected a heading"},
      {replaced("[[1,8,0]]", "[]"), 1, "sentences[1].path: expected a list of poses"},
      {replaced("[[1,8,0]]", "[[1,8]]"), 1, "sentences[1].path[0]: expected a pose"},
      {replaced("[[1,8,0]]", "[[1,8,0],[3,8,0]]"), 1, "sentences[1].path[1]: expected one action"},
      {replaced("[[1,8,0]]", "[[1,8,0],[1,8,180]]"), 1, "sentences[1].path[1]: expected one action"},
      {replaced("[[1,8,0]]", "[[1e9,8,0]]"), 1, "sentences[1].path[0][0]: expected a whole number"},
      {replaced("[[1,8,0]]", "[[99999999,8,0]]"), 1, "sentences[1].path[0][0]: expected a whole number"},
      {replaced("[[1,8,0]]", "[[99999999999,8,0]]"), 1, "sentences[1].path[0][0]: the number is too large"},
      {replaced("\"path_north\"", "\"path_south\""), 1, "sentences[0]: the key \"path_north\" is missing"},
      {replaced("[[1,9,0],[1,8,0]]", "[[1,9,-1],[1,8,0]]"), 1, "path_north[0]: expected a known heading"},
      {replaced("\"tokens\":[\"stay\",\"put\"]", "\"tokens\":[1]"), 1, "tokens[0]: expected a text"},
  };
  for (const auto& [text, line, message] : table) {
    try {
      parse_sail_corpus(text, "corpus.jsonl");
      ADD_FAILURE() << "accepted: " << text;
    } catch (const ltl::FormatError& error) {
      EXPECT_EQ(error.line(), line) << text;
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("corpus.jsonl"), std::string::npos) << error.what();
    }
  }
}

TEST(SailCorpus, AMissingDirectoryIsAFormatError) {
  EXPECT_THROW(read_sail_corpus("/nonexistent/sail"), ltl::FormatError);
}

TEST(SailCorpus, TheOpenCorpusReadsAsItsReadmeSays) {
  if (!std::filesystem::exists(sail_directory()))
    GTEST_SKIP() << "the SAIL corpus is not at " << sail_directory() << " (set WAYMARK_SHARED)";
  const Corpus corpus = read_sail_corpus(sail_directory());
  EXPECT_EQ(corpus.paragraphs.size(), 562U);
  EXPECT_EQ(corpus.sentences(), 2552U);
  EXPECT_EQ(corpus.maps.size(), 3U);
  std::size_t unknown = 0, segmented = 0;
  for (const Paragraph& paragraph : corpus.paragraphs) {
    segmented += paragraph.sentences.empty() ? 0 : 1;
    for (const Sentence& sentence : paragraph.sentences) {
      unknown += sentence.heading_unknown ? 1 : 0;
      EXPECT_EQ(tokenize(sentence.text), sentence.tokens) << sentence.id;
    }
  }
  EXPECT_EQ(segmented, 558U);
  EXPECT_EQ(unknown, 558U);
  const std::vector<Executor> executors(corpus.maps.begin(), corpus.maps.end());
  EXPECT_EQ(make_examples(corpus, executors, Convention::Absolute).sentences.size(), 2552U);
  EXPECT_EQ(make_examples(corpus, executors, Convention::Relative).sentences.size(), 2552U);
}

}  // namespace
}  // namespace waymark::parser
