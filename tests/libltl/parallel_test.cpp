#include "libltl/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace waymark::ltl {
namespace {

TEST(ParallelFor, RunsEachJobOnceAtAnyNumberOfThreads) {
  for (const std::size_t threads : {0U, 1U, 2U, 5U, 40U}) {
    std::vector<std::atomic<int>> runs(17);
    parallel_for(runs.size(), threads, [&](std::size_t job, std::size_t thread) {
      EXPECT_LT(thread, std::max<std::size_t>(threads, 1));
      ++runs[job];
    });
    for (std::size_t job = 0; job < runs.size(); ++job) EXPECT_EQ(runs[job], 1) << job << " of " << threads;
  }
  parallel_for(0, 2, [](std::size_t, std::size_t) { FAIL(); });
}

// No two jobs run at the same time under one number, so the numbers can be places for what a thread keeps.
TEST(ParallelFor, NumbersOfThreadsAreTheirOwn) {
  for (const std::size_t threads : {2U, 3U, 5U}) {
    std::vector<std::atomic<int>> at_work(threads);
    parallel_for(40, threads, [&](std::size_t, std::size_t thread) {
      EXPECT_EQ(at_work[thread]++, 0) << thread << " of " << threads;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --at_work[thread];
    });
  }
}

TEST(ParallelFor, ThreadZeroIsTheCaller) {
  const auto caller = std::this_thread::get_id();
  parallel_for(50, 3,
               [&](std::size_t, std::size_t thread) { EXPECT_EQ(thread == 0, std::this_thread::get_id() == caller); });
}

// Jobs 0 and 1 run at the same time, so one of them runs in a helper thread; both are made to throw from there.
TEST(ParallelFor, AnExceptionInAHelperThreadReachesTheCaller) {
  std::atomic<int> begun{0};
  const auto run = [&](std::size_t, std::size_t thread) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
    if (thread == 1) throw std::runtime_error("in the helper");
  };
  try {
    parallel_for(2, 2, run);
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "in the helper");
  }
}

TEST(ParallelFor, ThrowsTheErrorOfTheFirstJobAtAnyNumberOfThreads) {
  for (const std::size_t threads : {1U, 2U, 3U, 8U})
    for (int round = 0; round < 50; ++round) {
      const auto run = [&](std::size_t job, std::size_t) {
        if (job == 5) std::this_thread::sleep_for(std::chrono::microseconds(200));
        if (job >= 5) throw std::runtime_error("job " + std::to_string(job));
      };
      try {
        parallel_for(100, threads, run);
        ADD_FAILURE() << "no error";
      } catch (const std::runtime_error& error) {
        ASSERT_STREQ(error.what(), "job 5") << threads << " threads";
      }
    }
}

TEST(ParallelFor, StartsNoJobAfterAnErrorOrAStop) {
  std::atomic<int> started{0};
  const auto failing = [&](std::size_t job, std::size_t) {
    ++started;
    if (job == 2) throw std::runtime_error("job 2");
  };
  EXPECT_THROW(parallel_for(100, 1, failing), std::runtime_error);
  EXPECT_EQ(started, 3);
  std::stop_source stop;
  started = 0;
  const auto stopping = [&](std::size_t job, std::size_t) {
    ++started;
    if (job == 4) stop.request_stop();
  };
  parallel_for(100, 1, stopping, stop.get_token());
  EXPECT_EQ(started, 5);
  parallel_for(
      100, 2, [](std::size_t, std::size_t) { FAIL(); }, stop.get_token());
}

}  // namespace
}  // namespace waymark::ltl
