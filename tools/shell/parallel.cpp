#include "tools/shell/parallel.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <iostream>
#include <mutex>
#include <optional>
#include <thread>

#include "libltl/diagnostic.hpp"
#include "libltl/parallel.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

using Clock = std::chrono::steady_clock;

// One text's time: a stop of its own, requested by the watch when it is over.
class WorkerDeadline : public TextDeadline {
 public:
  std::stop_token token() const override { return stop_.get_token(); }
  bool passed() const override { return passed_; }

  void begin(double seconds, const std::stop_token& also) {
    const std::lock_guard lock(mutex_);
    if (stop_.stop_requested()) stop_ = std::stop_source();
    if (also.stop_requested()) stop_.request_stop();
    passed_ = false;
    end_ = seconds > 0
               ? Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))
               : Clock::time_point::max();
    running_ = true;
  }
  void end() {
    const std::lock_guard lock(mutex_);
    running_ = false;
  }
  void look(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (!running_ || now < end_) return;
    running_ = false;
    passed_ = true;
    stop_.request_stop();
  }
  void interrupt() {
    const std::lock_guard lock(mutex_);
    stop_.request_stop();
  }

 private:
  std::mutex mutex_;
  std::stop_source stop_;
  Clock::time_point end_;
  std::atomic<bool> passed_ = false;
  bool running_ = false;
};

class Batch {
 public:
  Batch(TextReader& texts, const std::stop_token& stop, const ParallelOptions& options, const Replier& answer,
        const BadTextReply& bad)
      : texts_(texts), stop_(stop), options_(options), answer_(answer), bad_(bad), workers_(options.threads) {}

  ExitCode run() {
    const std::stop_callback interrupted(stop_, [this] {
      for (WorkerDeadline& worker : workers_) worker.interrupt();
      room_.notify_all();
    });
    {
      std::jthread watch;
      if (options_.seconds > 0) watch = std::jthread([this](const std::stop_token& over) { keep_time(over); });
      ltl::parallel_for(workers_.size(), workers_.size(), [this](std::size_t i, std::size_t) { work(workers_[i]); });
    }
    if (stop_.stop_requested()) throw Interrupted();
    if (taken_ == 0) throw ltl::FormatError(texts_.source(), 0, 0, "there is nothing to read");
    return worst_;
  }

 private:
  struct Job {
    std::size_t number;
    Text text;
  };

  // Twenty looks a second, or a hundred for limits below a second: a limit is late by no more than that.
  void keep_time(const std::stop_token& over) {
    const auto pause = std::chrono::milliseconds(options_.seconds < 1 ? 10 : 50);
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    while (!over.stop_requested()) {
      never.wait_for(lock, over, pause, [] { return false; });
      for (WorkerDeadline& worker : workers_) worker.look(Clock::now());
    }
  }

  void work(WorkerDeadline& worker) {
    try {
      while (std::optional<Job> job = take()) {
        worker.begin(options_.seconds, stop_);
        Reply reply = reply_to(job->text, worker);
        worker.end();
        put(job->number, std::move(reply));
      }
    } catch (...) {
      const std::lock_guard lock(output_);
      failed_ = true;
      room_.notify_all();
      throw;
    }
  }

  bool over() const { return failed_ || stop_.stop_requested(); }

  std::optional<Job> take() {
    {
      std::unique_lock lock(output_);
      room_.wait(lock, [this] { return waiting_.size() < workers_.size() * 256 || over(); });
      if (over()) return std::nullopt;
    }
    const std::lock_guard lock(input_);
    std::optional<Text> text = texts_.next();
    if (!text) return std::nullopt;
    return Job{taken_++, std::move(*text)};
  }

  Reply reply_to(const Text& text, const WorkerDeadline& worker) const {
    if (!texts_.is_batch()) return answer_(text, worker);
    try {
      return answer_(text, worker);
    } catch (const ltl::SyntaxError& error) {
      return {ExitCode::BadInput, bad_(text, error.what()), error.what()};
    } catch (const ltl::FormatError& error) {
      return {ExitCode::BadInput, bad_(text, error.what()), error.what()};
    }
  }

  void put(std::size_t number, Reply reply) {
    const std::lock_guard lock(output_);
    if (stop_.stop_requested()) return;
    const std::size_t place = number - written_;
    if (waiting_.size() <= place) waiting_.resize(place + 1);
    waiting_[place] = std::move(reply);
    while (!waiting_.empty() && waiting_.front()) {
      const Reply& next = *waiting_.front();
      if (!next.problem.empty()) complain("error", next.problem);
      std::cout << next.text << std::flush;
      worst_ = worse(worst_, next.code);
      waiting_.pop_front();
      ++written_;
    }
    room_.notify_all();
  }

  TextReader& texts_;
  const std::stop_token& stop_;
  ParallelOptions options_;
  const Replier& answer_;
  const BadTextReply& bad_;
  std::deque<WorkerDeadline> workers_;  // one for each thread
  std::mutex input_, output_;
  std::condition_variable_any room_;
  std::size_t taken_ = 0;                     // under input_
  std::deque<std::optional<Reply>> waiting_;  // from here on under output_; the first one is number written_
  std::size_t written_ = 0;
  ExitCode worst_ = ExitCode::Done;
  bool failed_ = false;
};

}  // namespace

ExitCode answer_in_parallel(TextReader& texts, const std::stop_token& stop, const ParallelOptions& options,
                            const Replier& answer, const BadTextReply& bad) {
  ParallelOptions settled = options;
  if (settled.threads == 0) settled.threads = ltl::hardware_threads();
  if (!texts.is_batch()) settled.threads = 1;
  return Batch(texts, stop, settled, answer, bad).run();
}

}  // namespace waymark::tools
