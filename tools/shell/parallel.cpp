#include "tools/shell/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/parallel.hpp"
#include "tools/shell/chunk_size.hpp"
#include "tools/shell/giver.hpp"
#include "tools/shell/hand.hpp"
#include "tools/shell/seat.hpp"

namespace waymark::tools {
namespace {

using Clock = std::chrono::steady_clock;

// One text's limits: a stop of its own, requested when one of them is met.
class WorkerWatch : public TextWatch {
 public:
  std::stop_token token() const override { return stop_.get_token(); }
  ltl::Overrun overrun() const override { return overrun_; }

  void begin(double seconds, const std::stop_token& also) {
    const std::lock_guard lock(mutex_);
    if (stop_.stop_requested()) stop_ = std::stop_source();
    if (also.stop_requested()) stop_.request_stop();
    overrun_ = ltl::Overrun::None;
    begun_ = Clock::now();
    end_ = seconds > 0 ? begun_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))
                       : Clock::time_point::max();
    running_ = true;
  }
  void end() {
    const std::lock_guard lock(mutex_);
    running_ = false;
  }
  void look(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (running_ && now >= end_) give_up(ltl::Overrun::Time);
  }
  void give_memory_back() {
    const std::lock_guard lock(mutex_);
    if (running_) give_up(ltl::Overrun::Memory);
  }
  std::optional<Clock::time_point> begun() const {  // nullopt: at rest, or stopped already
    const std::lock_guard lock(mutex_);
    return running_ ? std::optional(begun_) : std::nullopt;
  }
  void interrupt() {
    const std::lock_guard lock(mutex_);
    stop_.request_stop();
  }

 private:
  void give_up(ltl::Overrun overrun) {
    running_ = false;
    overrun_ = overrun;
    stop_.request_stop();
  }

  mutable std::mutex mutex_;
  std::stop_source stop_;
  Clock::time_point begun_, end_;
  std::atomic<ltl::Overrun> overrun_ = ltl::Overrun::None;
  bool running_ = false;
};

// Where the texts of a batch come from, and where the replies go, in order: each from one thread at a time.
struct Ends {
  std::function<std::optional<DealtText>()> next;
  std::function<void(DealtText, const Reply&)> put;
};

class Batch {
 public:
  Batch(Ends ends, const std::stop_token& stop, const ParallelOptions& options, Replier answer)
      : ends_(std::move(ends)), stop_(stop), options_(options), answer_(std::move(answer)), workers_(options.threads) {}

  void run() {
    const std::stop_callback interrupted(stop_, [this] {
      for (WorkerWatch& worker : workers_) worker.interrupt();
      room_.notify_all();
    });
    {
      std::jthread watch;
      const WorkLimits& limits = options_.limits;
      if (limits.seconds > 0 || limits.mebibytes > 0)
        watch = std::jthread([this](const std::stop_token& over) { keep(over); });
      ltl::parallel_for(workers_.size(), workers_.size(), [this](std::size_t i, std::size_t) { work(workers_[i]); });
    }
    if (stop_.stop_requested()) throw Interrupted();
  }

 private:
  struct Job {
    std::size_t number;
    DealtText text;
  };
  struct Answered {
    DealtText text;
    Reply reply;
  };

  // Twenty looks a second, a hundred for limits below a second, two hundred for memory: a limit is late by no more.
  void keep(const std::stop_token& over) {
    const std::size_t bytes = granted(options_.limits).bytes;
    const auto pause = std::chrono::milliseconds(bytes > 0 ? 5 : options_.limits.seconds < 1 ? 10 : 50);
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    while (!over.stop_requested()) {
      never.wait_for(lock, over, pause, [] { return false; });
      for (WorkerWatch& worker : workers_) worker.look(Clock::now());
      if (bytes > 0 && ltl::memory_held() > bytes) free_memory();
    }
  }

  // The text that was begun first is taken for the one that holds most. It has a tenth of a second to let go.
  void free_memory() {
    if (ltl::memory_held() <= granted(options_.limits).bytes || Clock::now() < next_may_end_) return;
    WorkerWatch* first = nullptr;
    for (WorkerWatch& worker : workers_)
      if (worker.begun() && (first == nullptr || worker.begun() < first->begun())) first = &worker;
    if (first == nullptr) return;
    first->give_memory_back();
    next_may_end_ = Clock::now() + std::chrono::milliseconds(100);
  }

  void work(WorkerWatch& worker) {
    try {
      while (std::optional<Job> job = take()) {
        if (job->text.made) {
          Reply made = *job->text.made;
          put(std::move(*job), std::move(made));
          continue;
        }
        worker.begin(options_.limits.seconds, stop_);
        Reply reply = answer_(job->text.text, worker);
        worker.end();
        put(std::move(*job), std::move(reply));
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
    std::optional<DealtText> text = ends_.next();
    if (!text) return std::nullopt;
    return Job{taken_++, std::move(*text)};
  }

  void put(Job job, Reply reply) {
    const std::lock_guard lock(output_);
    if (stop_.stop_requested()) return;
    const std::size_t place = job.number - written_;
    if (waiting_.size() <= place) waiting_.resize(place + 1);
    waiting_[place] = Answered{std::move(job.text), std::move(reply)};
    while (!waiting_.empty() && waiting_.front()) {
      ends_.put(std::move(waiting_.front()->text), waiting_.front()->reply);
      waiting_.pop_front();
      ++written_;
    }
    room_.notify_all();
  }

  Ends ends_;
  const std::stop_token& stop_;
  ParallelOptions options_;
  Replier answer_;
  std::deque<WorkerWatch> workers_;  // one for each thread
  Clock::time_point next_may_end_;   // when memory is short; the keeper's alone
  std::mutex input_, output_;
  std::condition_variable_any room_;
  std::size_t taken_ = 0;                        // under input_
  std::deque<std::optional<Answered>> waiting_;  // from here on under output_; the first one is number written_
  std::size_t written_ = 0;
  bool failed_ = false;
};

// A bad text of a batch ends nothing but itself.
Replier of_batch(const Replier& answer, const BadTextReply& bad) {
  return [&](const Text& text, const TextWatch& watch) -> Reply {
    try {
      return answer(text, watch);
    } catch (const ltl::SyntaxError& error) {
      return {ExitCode::BadInput, bad(text, error.what()), error.what()};
    } catch (const ltl::FormatError& error) {
      return {ExitCode::BadInput, bad(text, error.what()), error.what()};
    }
  };
}

// Answers what the giver gives, until it is gone.
ExitCode answer_as_hand(const Seat& seat, const std::stop_token& stop, ParallelOptions options, const Replier& answer) {
  if (options.threads == 0) options.threads = 1;
  HandTexts given(seat);
  Batch({[&] { return given.next(); }, [&](const DealtText&, const Reply& reply) { given.put(reply); }}, stop, options,
        answer)
      .run();
  return ExitCode::Done;
}

}  // namespace

ExitCode answer_in_parallel(TextReader& texts, const std::stop_token& stop, const ParallelOptions& options,
                            const Replier& answer, const BadTextReply& bad) {
  const std::optional<Seat> seat = taken_seat();
  if (seat && seat->role == Seat::Role::Hand) return answer_as_hand(*seat, stop, options, of_batch(answer, bad));
  DealtTexts dealt(texts, options.deal, options.settings);
  if (seat && texts.is_batch()) return give_out(dealt, *seat, stop, bad);
  ParallelOptions settled = options;
  if (settled.threads == 0) settled.threads = ltl::hardware_threads();
  if (!texts.is_batch()) settled.threads = 1;
  ReplyOutput output;
  ReplyKeeper keeper(dealt.kept(), chunk_seconds());
  const auto put = [&](DealtText text, const Reply& reply) {
    output.put(reply);
    ReplyOutput::flush();
    keeper.put(std::move(text), reply);
  };
  Batch({[&] { return dealt.next(); }, put}, stop, settled, texts.is_batch() ? of_batch(answer, bad) : answer).run();
  keeper.end_part();
  return output.worst();
}

ExitCode answer_in_parallel(std::size_t jobs, const std::stop_token& stop, const ParallelOptions& options,
                            const JobReplier& answer) {
  ParallelOptions settled = options;
  if (settled.threads == 0) settled.threads = ltl::hardware_threads();
  settled.threads = std::clamp<std::size_t>(jobs, 1, settled.threads);
  std::size_t next = 0;
  const auto number = [&]() -> std::optional<DealtText> {
    if (next == jobs) return std::nullopt;
    const std::size_t job = next++;
    return DealtText{job, Text{"", "", job}};
  };
  ReplyOutput output;
  const auto put = [&](const DealtText&, const Reply& reply) {
    output.put(reply);
    ReplyOutput::flush();
  };
  Batch({number, put}, stop, settled, [&](const Text& job, const TextWatch& watch) {
    return answer(job.line, watch);
  }).run();
  return output.worst();
}

}  // namespace waymark::tools
