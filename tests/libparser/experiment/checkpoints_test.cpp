#include "libparser/experiment/checkpoints.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "libltl/diagnostic.hpp"
#include "libparser/experiment/evaluate.hpp"
#include "libparser/experiment/scores_text.hpp"
#include "libparser/language/generate.hpp"
#include "tests/libparser/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace waymark::parser {
namespace {

namespace fs = std::filesystem;

class CheckpointDirectory : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove_all(directory); }
  const fs::path directory = fs::temp_directory_path() / ("waymark-checkpoints-" + std::to_string(::getpid()));
};

std::vector<fs::path> files_in(const fs::path& directory, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST_F(CheckpointDirectory, KeepsBytesUnderTheirName) {
  const Checkpoints checkpoints(directory, "seed 1\n");
  EXPECT_FALSE(checkpoints.find("a"));
  const std::string bytes("x\0y\n", 4);
  checkpoints.keep("a", bytes);
  EXPECT_TRUE(checkpoints.has("a"));
  EXPECT_EQ(Checkpoints(directory, "seed 1\n").find("a"), bytes);
  EXPECT_EQ(files_in(directory, ".tmp").size(), 0U);
}

TEST_F(CheckpointDirectory, OfOtherSettingsIsRefused) {
  const Checkpoints checkpoints(directory, "seed 1\n");
  EXPECT_THROW(Checkpoints(directory, "seed 2\n"), ltl::FormatError);
}

TEST(ScoresText, ReadsBackWhatItWrites) {
  Scores scores;
  scores.sentence = {{1, 2}, {3, 4}};
  scores.paragraph = {{5, 6}, {7, 8}};
  scores.path = {{9, 10}, {11, 12}, {13, 14}};
  scores.paragraph_path = {{15, 16}, {17, 18}, {19, 20}};
  scores.satisfiable = {21, 22};
  scores.unheard = {{23, 24}, {25, 26}};
  scores.skipped_paragraphs = 27;
  const std::string line = text_of(scores);
  EXPECT_EQ(line, "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27\n");
  EXPECT_EQ(text_of(scores_of(line, "")), line);
  EXPECT_THROW(scores_of("1 2 3", ""), ltl::FormatError);
  EXPECT_THROW(scores_of(line + "28", ""), ltl::FormatError);
}

// Whatever is missing is made again, and all scores are the same: after every kind of part is taken away in turn.
TEST_F(CheckpointDirectory, AnExperimentGoesOnToTheSameScores) {
  const std::size_t paragraphs = testing::sanitized ? 6 : 12;
  const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 7, .paragraphs = paragraphs, .sentences = 3});
  const Checkpoints checkpoints(directory, "");
  EvaluateOptions options;
  options.relative = false;
  options.ensemble = 2;
  options.train.epochs = testing::sanitized ? 1 : 2;
  options.checkpoints = &checkpoints;
  options.system = "linear";
  const auto run = [&] {
    const Evaluation result = evaluate_leave_one_map_out(corpus, nullptr, shipped_maps(), options);
    std::string lines = text_of(result.all);
    for (const Scores& single : result.singles) lines += text_of(single);
    return lines;
  };
  const std::string whole = run();
  EXPECT_EQ(files_in(directory, ".reader").size(), 12U);  // of each member: pairs of maps, and single maps
  EXPECT_EQ(files_in(directory, ".reranker").size(), 6U);
  EXPECT_EQ(files_in(directory, ".scores").size(), 3U);
  EXPECT_EQ(run(), whole);  // nothing is left to do
  for (const char* kind : {".reader", ".reranker"}) {
    fs::remove(files_in(directory, ".scores").front());
    fs::remove(files_in(directory, kind).front());
    EXPECT_EQ(run(), whole) << kind;
  }
  fs::remove_all(directory);  // and with nothing kept
  const Checkpoints empty(directory, "");
  EXPECT_EQ(run(), whole);
}

}  // namespace
}  // namespace waymark::parser
