#include "libparser/training/parallel.hpp"

#include <algorithm>
#include <mutex>
#include <vector>

#include "libltl/parallel.hpp"

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
  ltl::parallel_for(jobs, static_cast<std::size_t>(std::max(threads, 1)), [&](std::size_t job, std::size_t thread) {
    const JobProgress progress = [&](double fraction) {
      const double all = mean.update(job, fraction);
      if (thread == 0 && report) report(all, what);
    };
    run(job, progress);
    progress(1.0);
  });
}

}  // namespace waymark::parser
