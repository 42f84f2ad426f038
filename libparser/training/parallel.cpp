#include "libparser/training/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace waymark::parser {
namespace {

// The mean progress of all jobs.
class Mean {
 public:
  explicit Mean(std::size_t jobs) : done_(jobs, 0.0) {}

  double update(std::size_t job, double fraction) {
    const std::lock_guard lock(mutex_);
    sum_ += std::max(0.0, fraction - done_[job]);
    done_[job] = std::max(done_[job], fraction);
    return std::min(1.0, sum_ / static_cast<double>(done_.size()));
  }

 private:
  std::mutex mutex_;
  std::vector<double> done_;
  double sum_ = 0;
};

}  // namespace

void run_jobs(std::size_t jobs, int threads, const Report& report, std::string_view what,
              const std::function<void(std::size_t job, const JobProgress& progress)>& run) {
  Mean mean(jobs);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::vector<std::exception_ptr> errors(jobs);
  const auto work = [&](bool reports) {
    for (std::size_t job = next++; job < jobs && !failed; job = next++) {
      const JobProgress progress = [&, job](double fraction) {
        const double all = mean.update(job, fraction);
        if (reports && report) report(all, what);
      };
      try {
        run(job, progress);
        progress(1.0);
      } catch (...) {  // kept for the caller, who gets the first of them
        errors[job] = std::current_exception();
        failed = true;
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    const auto wanted = static_cast<std::size_t>(std::max(threads, 1));
    for (std::size_t t = 1; t < std::min(wanted, jobs); ++t) helpers.emplace_back(work, false);
    work(true);
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace waymark::parser
