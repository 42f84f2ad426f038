// The driver of optimistic value iteration, with a backend that tells what it is asked for.
#include "libplan/solve/optimistic_iteration.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace waymark::plan {
namespace {

struct Scripted {
  Scripted(std::size_t how_often_refined, std::size_t how_often_refuted)
      : refined(how_often_refined), refuted(how_often_refuted) {}
  std::size_t refined, refuted, sweeps_of_a_refinement = 3;
  std::uint64_t swept = 0;
  std::vector<double> changes, tolerances;
  std::vector<std::uint64_t> sweeps_before;

  std::uint64_t sweeps() const { return swept; }
  bool refine(double change, const IterationOptions&) {
    changes.push_back(change);
    swept += sweeps_of_a_refinement++;
    return changes.size() <= refined;
  }
  void guess(double tolerance) { tolerances.push_back(tolerance); }
  bool prove(std::uint64_t since, const IterationOptions&) {
    sweeps_before.push_back(since);
    return sweeps_before.size() > refuted;
  }
};

TEST(OptimisticIteration, RefinesUntilAGuessIsProved) {
  Scripted backend{SIZE_MAX, 3};
  EXPECT_EQ(iterate_optimistically(backend, {.tolerance = 0.25}, 1.0), IterationEnd::Proved);
  EXPECT_EQ(backend.changes, (std::vector<double>{1, 1 / 64.0, 1 / 4096.0, 1 / 262'144.0}));
  EXPECT_EQ(backend.tolerances, std::vector<double>(4, 0.25));
  EXPECT_EQ(backend.sweeps_before, (std::vector<std::uint64_t>{3, 4, 5, 6})) << "of the refinement before";
}

// Changes become smaller down to none at all, and then nothing finer can be asked for.
TEST(OptimisticIteration, EndsWhereNothingFinerCanBeAskedFor) {
  Scripted backend{SIZE_MAX, SIZE_MAX};
  EXPECT_EQ(iterate_optimistically(backend, {}, 1.0), IterationEnd::NotProved);
  ASSERT_GT(backend.changes.size(), 2U);
  EXPECT_EQ(backend.changes.back(), 0);
  for (std::size_t i = 1; i + 1 < backend.changes.size(); ++i) {
    EXPECT_EQ(backend.changes[i], backend.changes[i - 1] / 64);
    EXPECT_GE(backend.changes[i - 1], 1e-24);
  }
  EXPECT_LT(backend.changes[backend.changes.size() - 2], 1e-24);
}

TEST(OptimisticIteration, EndsOutOfLimits) {
  Scripted refused{1, SIZE_MAX};
  EXPECT_EQ(iterate_optimistically(refused, {}, 1.0), IterationEnd::OutOfLimits);
  EXPECT_EQ(refused.changes.size(), 2U);
  EXPECT_EQ(refused.tolerances.size(), 1U) << "what is not refined is no ground for a guess";
  std::stop_source source;
  source.request_stop();
  Scripted stopped{SIZE_MAX, 1}, proved{SIZE_MAX, 0};
  EXPECT_EQ(iterate_optimistically(stopped, {.stop = source.get_token()}, 1.0), IterationEnd::OutOfLimits);
  EXPECT_EQ(stopped.changes.size(), 1U);
  EXPECT_EQ(iterate_optimistically(proved, {.stop = source.get_token()}, 1.0), IterationEnd::Proved);
}

TEST(OptimisticIteration, RoundingIsNoRise) {
  EXPECT_FALSE(raises(1, 1));
  EXPECT_FALSE(raises(1, 0.5));
  EXPECT_FALSE(raises(1, 1 + 2e-16));
  EXPECT_TRUE(raises(1, 1 + 2e-15));
  EXPECT_FALSE(raises(0, 0));
  EXPECT_TRUE(raises(0, 1e-300));
}

}  // namespace
}  // namespace waymark::plan
