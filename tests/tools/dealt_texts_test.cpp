// Batches in shares, batches whose answers are kept, and the messages of a farm.
#include "tools/shell/dealt_texts.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <random>

#include "libltl/diagnostic.hpp"
#include "tools/shell/parallel.hpp"

namespace waymark::tools {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> numbered(std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(std::to_string(i));
  return out;
}

struct DealtOutcome {
  std::string output;
  std::size_t answered = 0;  // by this run
};

class DealtBatch : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder); }

  DealtOutcome run(const std::vector<std::string>& texts, const DealOptions& deal,
                   const std::string& settings = "") const {
    TextReader reader({.arguments = texts, .file = ""}, "text");
    ParallelOptions options{.threads = 2, .deal = deal};
    options.settings = [&] { return settings; };
    std::atomic<std::size_t> answered = 0;
    const auto answer = [&](const Text& text, const TextWatch&) {
      ++answered;
      return Reply{ExitCode::Done, "re " + text.text + "\n"};
    };
    testing::internal::CaptureStdout();
    try {
      answer_in_parallel(reader, {}, options, answer, {});
    } catch (...) {
      testing::internal::GetCapturedStdout();
      throw;
    }
    return {testing::internal::GetCapturedStdout(), answered};
  }

  static std::string replies_to(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += "re " + text + "\n";
    return all;
  }

  std::vector<fs::path> parts() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".replies") found.push_back(entry.path());
    return found;
  }

  const fs::path folder = fs::temp_directory_path() / ("waymark-dealt-" + std::to_string(::getpid()));
};

TEST_F(DealtBatch, SharesOneAfterTheOtherAreTheWhole) {
  for (const std::size_t count : {2U, 7U, 100U})
    for (const std::size_t of : {1U, 2U, 3U, 7U, 13U}) {
      std::string all;
      std::size_t answered = 0, fewest = count, most = 0;
      for (std::size_t share = 1; share <= of; ++share) {
        const DealtOutcome part = run(numbered(count), {.share = std::to_string(share) + "/" + std::to_string(of)});
        all += part.output;
        answered += part.answered;
        fewest = std::min(fewest, part.answered);
        most = std::max(most, part.answered);
      }
      EXPECT_EQ(all, replies_to(numbered(count))) << count << " of " << of;
      EXPECT_EQ(answered, count);
      EXPECT_LE(most - fewest, 1U) << count << " of " << of;
    }
}

TEST_F(DealtBatch, WhatIsNoShareIsRefused) {
  for (const char* share : {"0/2", "3/2", "1", "1/", "/2", "a/b", "1/2x", "-1/2"})
    EXPECT_THROW(run(numbered(2), {.share = share}), UsageError) << share;
  TextReader input({.arguments = {"-"}, .file = ""}, "text");
  EXPECT_THROW(DealtTexts(input, {.share = "1/2"}, {}), UsageError);
}

// Of a file, lines are counted as they are read: without those that are blank or begin with #.
TEST_F(DealtBatch, SharesOfAFileCountItsTexts) {
  fs::create_directories(folder);
  const fs::path file = folder / "texts";
  std::ofstream(file) << "# three\n\na\n  \nb\n#\nc\n";
  std::string all;
  for (const char* share : {"1/2", "2/2"}) {
    TextReader reader({.arguments = {}, .file = file.string()}, "text");
    DealtTexts dealt(reader, {.share = share}, {});
    while (const auto text = dealt.next())
      all += std::to_string(text->number) + text->text.text + std::to_string(text->text.line) + ' ';
    all += '|';
  }
  EXPECT_EQ(all, "0a3 |1b5 2c7 |");
}

TEST_F(DealtBatch, KeptAnswersAreFoundAgain) {
  const std::vector<std::string> texts = numbered(500);
  const DealOptions kept{.kept = folder.string()};
  EXPECT_EQ(run(texts, kept).answered, 500U);
  const DealtOutcome again = run(texts, kept);
  EXPECT_EQ(again.answered, 0U);
  EXPECT_EQ(again.output, replies_to(texts));
}

// Shares of any number and in any order, some parts taken away, some damaged: the whole has the same bytes.
TEST_F(DealtBatch, WhateverIsMissingIsAnsweredAnew) {
  std::mt19937 random(1);
  const std::vector<std::string> texts = numbered(300);
  for (int round = 0; round < 30; ++round) {
    fs::remove_all(folder);
    for (std::size_t runs = 1 + random() % 4U; runs > 0; --runs) {
      const std::size_t of = 1 + random() % 5U, share = 1 + random() % of;
      run(texts, {.share = std::to_string(share) + "/" + std::to_string(of), .kept = folder.string()});
    }
    for (const fs::path& part : parts()) {
      if (random() % 3U == 0)
        fs::remove(part);
      else if (random() % 3U == 0)
        fs::resize_file(part, fs::file_size(part) / 2);
    }
    EXPECT_EQ(run(texts, {.kept = folder.string()}).output, replies_to(texts)) << "round " << round;
    EXPECT_EQ(run(texts, {.share = "2/3", .kept = folder.string()}).answered, 0U) << "round " << round;
  }
}

TEST_F(DealtBatch, AnswersToOtherTextsAreRefused) {
  const DealOptions kept{.kept = folder.string()};
  std::vector<std::string> texts = numbered(50);
  run(texts, kept, "seed 1\n");
  EXPECT_THROW(run(texts, kept, "seed 2\n"), ltl::FormatError);
  texts[30] = "another";
  try {
    run(texts, kept, "seed 1\n");
    FAIL() << "taken";
  } catch (const ltl::FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("holds answers to other texts"), std::string::npos) << error.what();
  }
}

TEST(Packed, MessagesAreReadAsTheyWereWritten) {
  const std::string bytes("a\0\n", 3);
  const std::string packed = Packed().number(0).text(bytes).number(~std::uint64_t{0}).text("").rest("rest").bytes();
  Unpacked message(packed);
  EXPECT_EQ(message.number(), 0U);
  EXPECT_EQ(message.text(), bytes);
  EXPECT_EQ(message.number(), ~std::uint64_t{0});
  EXPECT_EQ(message.text(), "");
  EXPECT_EQ(message.rest(), "rest");
  EXPECT_THROW(message.number(), std::logic_error);
  EXPECT_THROW(Unpacked(std::string_view(packed).substr(8, 9)).text(), std::logic_error);
}

TEST(Packed, FramesAreCutWhereverTheirBytesWereCut) {
  const std::vector<std::string> frames{"", "a", std::string(1000, 'b'), "c"};
  std::string bytes;
  for (const std::string& frame : frames) bytes += framed(frame);
  for (const std::size_t step : {1U, 3U, 8U, 500U, 5000U}) {
    FrameCutter cutter;
    std::vector<std::string> found;
    for (std::size_t at = 0; at < bytes.size(); at += step) {
      cutter.add(std::string_view(bytes).substr(at, step));
      while (auto frame = cutter.next()) found.push_back(std::move(*frame));
    }
    EXPECT_EQ(found, frames) << step;
  }
}

}  // namespace
}  // namespace waymark::tools
