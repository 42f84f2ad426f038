#include "libparser/experiment/checkpoints.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "libltl/diagnostic.hpp"
#include "libparser/experiment/evaluate.hpp"
#include "libparser/experiment/scores_text.hpp"
#include "libparser/experiment/shared_jobs.hpp"
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

std::set<std::string> names_in(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) names.insert(entry.path().filename().string());
  return names;
}

TEST_F(CheckpointDirectory, KeepsBytesUnderTheirName) {
  const Checkpoints checkpoints(directory, "seed 1\n");
  EXPECT_FALSE(checkpoints.find("a"));
  const std::string bytes("x\0y\n", 4);
  checkpoints.keep("a", bytes);
  EXPECT_TRUE(checkpoints.has("a"));
  EXPECT_EQ(Checkpoints(directory, "seed 1\n").find("a"), bytes);
  const std::set<std::string> left = names_in(directory);
  EXPECT_EQ(left.count("a"), 1U);
  EXPECT_TRUE(std::none_of(left.begin(), left.end(), [](const std::string& name) { return name[0] == '.'; }));
}

// Two objects stand for two processes: a claim is of the open file, not of the process.
TEST_F(CheckpointDirectory, APartHasOneMakerAtATime) {
  const Checkpoints ours(directory, ""), theirs(directory, "");
  std::optional<Claim> claim = ours.claim("a");
  ASSERT_TRUE(claim);
  EXPECT_FALSE(theirs.claim("a"));
  EXPECT_FALSE(ours.claim("a"));
  EXPECT_TRUE(theirs.claim("b"));
  claim.reset();
  EXPECT_TRUE(theirs.claim("a"));
}

// Each of many jobs is run once by one of several loops; who waits then runs the others', to find what they made.
TEST_F(CheckpointDirectory, SeveralLoopsShareTheirJobs) {
  const Checkpoints checkpoints(directory, "");
  constexpr std::size_t count = 40, loops = 4;
  std::vector<std::atomic<int>> made(count), seen(count);
  const auto loop = [&](bool waits) {
    run_shared_jobs({.count = count,
                     .part = [](std::size_t job) { return std::to_string(job); },
                     .run =
                         [&](std::size_t job, const JobProgress&) {
                           if (!checkpoints.has(std::to_string(job))) {
                             std::this_thread::sleep_for(std::chrono::milliseconds(1));
                             ++made[job];
                             checkpoints.keep(std::to_string(job), "made");
                           }
                           if (waits) ++seen[job];
                         },
                     .waits = waits},
                    {.checkpoints = &checkpoints, .threads = 2}, nullptr, "");
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < loops; ++i) threads.emplace_back(loop, i % 2 == 0);
  }
  for (std::size_t job = 0; job < count; ++job) {
    EXPECT_EQ(made[job], 1) << job;
    EXPECT_EQ(seen[job], 2) << job;
  }
}

TEST_F(CheckpointDirectory, OfOtherSettingsIsRefused) {
  const Checkpoints checkpoints(directory, "seed 1\n");
  try {
    const Checkpoints others(directory, "seed 2\n");
    FAIL() << "taken";
  } catch (const ltl::FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("'seed 1', not 'seed 2'"), std::string::npos) << error.what();
  }
}

// Every bit of every byte turned over, and every shorter file: nothing of it is ever taken for the text.
TEST_F(CheckpointDirectory, ADamagedTextIsNotFound) {
  const Checkpoints checkpoints(directory, "");
  const std::string text = "1 2 3\n4 5\n";
  checkpoints.keep_text("a", text);
  EXPECT_EQ(checkpoints.find_text("a"), text);
  EXPECT_FALSE(checkpoints.find_text("b"));
  const std::string whole = *checkpoints.find("a");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    checkpoints.keep("a", whole.substr(0, at));
    EXPECT_FALSE(checkpoints.find_text("a")) << at;
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      checkpoints.keep("a", damaged);
      EXPECT_FALSE(checkpoints.find_text("a")) << at << ' ' << bit;
    }
  }
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
  const fs::path scores = files_in(directory, ".scores").front();
  std::string damaged = *checkpoints.find(scores.filename().string());
  const std::size_t last_digit = damaged.find_last_of("0123456789");
  damaged[last_digit] = static_cast<char>(damaged[last_digit] ^ 1);
  checkpoints.keep(scores.filename().string(), damaged);  // another number, and the line is as good as any
  EXPECT_EQ(run(), whole);
  fs::remove_all(directory);  // and with nothing kept
  const Checkpoints empty(directory, "");
  EXPECT_EQ(run(), whole);
}

}  // namespace
}  // namespace waymark::parser
