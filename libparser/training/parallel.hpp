// The parallel loop with one report of progress.
#pragma once
#include <cstddef>
#include <functional>
#include <string_view>

namespace waymark::parser {

// How far the whole work is, in [0, 1]; called from one thread only, never decreasing.
using Report = std::function<void(double fraction, std::string_view what)>;
// How far one job is; may be called from any thread.
using JobProgress = std::function<void(double fraction)>;

// run(job, progress) for every job in [0, jobs), as ltl::parallel_for runs them. The caller's thread reports the mean
// progress of all jobs.
void run_jobs(std::size_t jobs, int threads, const Report& report, std::string_view what,
              const std::function<void(std::size_t job, const JobProgress& progress)>& run);

}  // namespace waymark::parser
