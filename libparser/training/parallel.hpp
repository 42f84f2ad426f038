// Independent jobs on several threads, with one report of progress.
#pragma once
#include <cstddef>
#include <functional>
#include <string_view>

namespace waymark::parser {

// How far the whole work is, in [0, 1]; called from one thread only, never decreasing.
using Report = std::function<void(double fraction, std::string_view what)>;
// How far one job is; may be called from any thread.
using JobProgress = std::function<void(double fraction)>;

// run(job, progress) for every job in [0, jobs), started in that order, on so many threads, the caller's among them.
// The caller's thread reports the mean of all jobs' progress. Returns when all threads are done; then the error of the
// first job that threw is thrown. No job is started after an error.
void run_jobs(std::size_t jobs, int threads, const Report& report, std::string_view what,
              const std::function<void(std::size_t job, const JobProgress& progress)>& run);

}  // namespace waymark::parser
