// Progress where nothing redraws itself: whole lines, by the clock that the caller has.
#include "tools/shell/terminal.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace waymark::tools {
namespace {

using std::chrono::milliseconds;

const ProgressLines::Clock::time_point start{};

TEST(ProgressLines, AShortJobHasNone) {
  ProgressLines lines(milliseconds(5'000));
  for (int i = 0; i <= 4'999; i += 17) EXPECT_EQ(lines.line(start + milliseconds(i), i / 5000.0, "learning"), "");
}

TEST(ProgressLines, ALongJobHasAWholeLineEachTimeThatTheIntervalHasPassed) {
  ProgressLines lines(milliseconds(5'000));
  std::string all;
  for (int i = 0; i <= 20'000; i += 10) all += lines.line(start + milliseconds(i), i / 20'000.0, "learning");
  EXPECT_EQ(all, "learning: 25 %\nlearning: 50 %\nlearning: 75 %\nlearning: 100 %\n");
}

TEST(ProgressLines, ReportsThatComeSeldomAreAllThere) {
  ProgressLines lines(milliseconds(5'000));
  std::string all;
  for (int i = 0; i <= 3; ++i) all += lines.line(start + milliseconds(60'000 * i), i / 4.0, "epochs");
  EXPECT_EQ(all, "epochs: 25 %\nepochs: 50 %\nepochs: 75 %\n");
}

// Standard error of a test is a pipe or a file once it is captured.
TEST(ProgressBar, WritesNoCarriageReturnWhereNothingRedrawsItself) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar;
    for (int i = 0; i <= 100; ++i) bar.show(i / 100.0, "learning");
    bar.wipe();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr().find_first_of("\r\x1b"), std::string::npos);
}

}  // namespace
}  // namespace waymark::tools
