// Texts from arguments, files and pipes, with the line they came from.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "libltl/diagnostic.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/options.hpp"

namespace waymark::tools {
namespace {

class Input : public ::testing::Test {
 protected:
  Input() : file_(std::filesystem::temp_directory_path() / ("waymark-input-" + std::to_string(::getpid()))) {}
  ~Input() override { std::filesystem::remove(file_); }
  TextReader reader(const std::string& contents) {
    std::ofstream(file_, std::ios::binary) << contents;
    return TextReader({.arguments = {}, .file = file_.string()}, "formula");
  }
  std::filesystem::path file_;
};

TEST_F(Input, CountsTheLinesThatItPassesOver) {
  TextReader texts = reader("F a\n\n# note\n  \t\nG b\r\nX c");
  std::vector<std::pair<std::string, std::size_t>> read;
  while (const auto text = texts.next()) read.emplace_back(text->text, text->line);
  EXPECT_EQ(read, (std::vector<std::pair<std::string, std::size_t>>{{"F a", 1}, {"G b", 5}, {"X c", 6}}));
}

TEST_F(Input, GivesArgumentsInOrder) {
  TextReader texts({.arguments = {"a", "b"}, .file = ""}, "formula");
  EXPECT_TRUE(texts.is_batch());
  EXPECT_EQ(texts.next()->text, "a");
  EXPECT_EQ(texts.next()->text, "b");
  EXPECT_FALSE(texts.next());
}

TEST_F(Input, RefusesArgumentsBesideAFile) {
  EXPECT_THROW(TextReader({.arguments = {"a"}, .file = "b"}, "formula"), UsageError);
}

TEST_F(Input, OfABatchIsAnsweredToItsEndWhenALineIsBad) {
  TextReader texts = reader("F a\nF (\nF b\n");
  std::vector<std::size_t> answered;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const ExitCode code = answer_each(
      texts, {},
      [&](const Text& text) {
        ltl::Arena arena;
        parse_formula(text, arena, {});
        answered.push_back(text.line);
        return ExitCode::Done;
      },
      true);
  const std::string refused = testing::internal::GetCapturedStdout();
  const std::string messages = testing::internal::GetCapturedStderr();
  EXPECT_EQ(code, ExitCode::BadInput);
  EXPECT_EQ(answered, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(refused.rfind(R"({"line":2,"status":"error",)", 0), 0U) << refused;
  EXPECT_EQ(std::count(refused.begin(), refused.end(), '\n'), 1);
  EXPECT_NE(messages.find(file_.string() + ":2:"), std::string::npos) << messages;
}

TEST_F(Input, ThatIsEmptyIsNotPassedOverInSilence) {
  TextReader texts = reader("# only a comment\n");
  EXPECT_THROW(answer_each(texts, {}, [](const Text&) { return ExitCode::Done; }), ltl::FormatError);
}

TEST_F(Input, StopsBetweenTextsWhenAsked) {
  TextReader texts = reader("F a\nF b\n");
  std::stop_source stop;
  EXPECT_THROW(answer_each(texts, stop.get_token(),
                           [&](const Text&) {
                             stop.request_stop();
                             return ExitCode::Done;
                           }),
               Interrupted);
}

TEST(ExitCodes, OfABatchIsTheWorst) {
  EXPECT_EQ(worse(ExitCode::No, ExitCode::BadInput), ExitCode::BadInput);
  EXPECT_EQ(worse(ExitCode::GaveUp, ExitCode::No), ExitCode::GaveUp);
  EXPECT_EQ(worse(ExitCode::Done, ExitCode::No), ExitCode::No);
}

}  // namespace
}  // namespace waymark::tools
