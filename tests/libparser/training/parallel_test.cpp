#include "libparser/training/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace waymark::parser {
namespace {

TEST(RunJobs, RunsEachJobOnceAtAnyNumberOfThreads) {
  for (int threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> runs(17);
    run_jobs(runs.size(), threads, nullptr, "", [&](std::size_t job, const JobProgress&) { ++runs[job]; });
    for (std::size_t job = 0; job < runs.size(); ++job) EXPECT_EQ(runs[job], 1) << job << " of " << threads;
  }
  run_jobs(0, 2, nullptr, "", [](std::size_t, const JobProgress&) { FAIL(); });
}

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

TEST(RunJobs, ThrowsTheFirstErrorAndStartsNoMore) {
  std::atomic<int> started{0};
  const auto run = [&](std::size_t job, const JobProgress&) {
    ++started;
    if (job >= 2) throw std::runtime_error("job " + std::to_string(job));
  };
  try {
    run_jobs(100, 1, nullptr, "", run);
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "job 2");
  }
  EXPECT_EQ(started, 3);
}

}  // namespace
}  // namespace waymark::parser
