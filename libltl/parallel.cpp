#include "libltl/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace waymark::ltl {
namespace {

// The exception of the first job that threw one. Whether there is one decides if another job starts.
class FirstError {
 public:
  bool any() const { return any_; }

  void keep(std::size_t job, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (error_ && job_ < job) return;
    job_ = job;
    error_ = std::move(error);
    any_ = true;
  }

  void rethrow() const {  // after all threads are done
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::size_t job_ = 0;
  std::exception_ptr error_;
  std::atomic<bool> any_{false};
};

}  // namespace

void parallel_for(std::size_t jobs, std::size_t threads,
                  const std::function<void(std::size_t job, std::size_t thread)>& run, const std::stop_token& stop) {
  std::atomic<std::size_t> next{0};
  FirstError first;
  // A job that was taken is run: the first job that throws is therefore the same on any number of threads.
  const auto work = [&](std::size_t thread) {
    while (!first.any() && !stop.stop_requested()) {
      const std::size_t job = next++;
      if (job >= jobs) return;
      try {
        run(job, thread);
      } catch (...) {
        first.keep(job, std::current_exception());
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    try {
      for (std::size_t t = 1; t < std::min(threads, jobs); ++t) helpers.emplace_back(work, t);
    } catch (const std::system_error&) {  // the system gives no more threads: those that it gave do the work
    }
    work(0);
  }
  first.rethrow();
}

std::size_t hardware_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace waymark::ltl
