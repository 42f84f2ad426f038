#include "libparser/training/parallel.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace waymark::parser {
namespace {

TEST(RunJobs, ReportsFromTheCallersThreadAndNeverGoesBack) {
  const auto caller = std::this_thread::get_id();
  double last = 0;
  const Report report = [&](double fraction, std::string_view what) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(what, "counting");
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
  };
  run_jobs(8, 1, report, "counting", [](std::size_t, const JobProgress& progress) {
    for (double fraction : {0.25, 0.5, 0.1, 0.75}) progress(fraction);
  });
  EXPECT_DOUBLE_EQ(last, 1.0);
  run_jobs(
      8, 3, [&](double, std::string_view) { EXPECT_EQ(std::this_thread::get_id(), caller); }, "counting",
      [](std::size_t, const JobProgress& progress) { progress(0.5); });
}

}  // namespace
}  // namespace waymark::parser
