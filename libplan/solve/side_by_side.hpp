// Passes over several parts by several threads, with the numbers of one thread to the last bit.
//
// In a pass every part is worked on once, in any order and by any thread; the next pass begins when all parts are done.
// A part is taken by the same thread again and again, as long as this one is in time, so that its numbers stay in that
// thread's cache.
#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "libltl/parallel.hpp"
#include "libplan/solve/pipelined_passes.hpp"

namespace waymark::plan {

struct PassInTurn {    // a pass and what it follows
  Pass pass, before;   // and the pass before it; of the first one no chunks
  std::size_t number;  // from 0
};

// work(part, PassInTurn) -> the first chunk of the part that has not settled, or pass.end. Touches what belongs to the
//   part, and reads of others what passes before this one have written for it.
// next(pass, unsettled) -> optional<Pass>: what follows a pass whose first unsettled chunk this is; nothing: it was the
//   last. Called once a pass, never at the same time.
// Memory: O(parts). A pass moves some four lines of the cache between two threads, whatever the number of parts.
template <class Work, class Next>
class PassesSideBySide {
 public:
  PassesSideBySide(std::size_t parts, std::size_t threads, const Work& work, Next& next)
      : threads_(std::min(threads, parts)), work_(work), next_(next), parts_(parts) {}

  void run(const Pass& first) {  // until there are no more
    now_.passes = {first, Pass{0, 0}};
    ltl::parallel_for(threads_, threads_, [this](std::size_t, std::size_t thread) { run_passes(thread); });
  }

 private:
  static constexpr std::size_t finished = SIZE_MAX;
  struct alignas(64) Part {             // a line of the cache each
    std::atomic<std::size_t> taken{0};  // in how many passes
  };
  struct Done {  // of a pass, by some parts
    std::uint32_t parts = 0, unsettled = UINT32_MAX;
  };

  // Parts in the upper half, in the lower one the first unsettled chunk.
  static constexpr std::uint64_t none_done = UINT32_MAX;
  static std::uint64_t together(std::uint64_t all, const Done& more) {
    return (((all >> 32U) + more.parts) << 32U) | std::min(static_cast<std::uint32_t>(all), more.unsettled);
  }

  void run_passes(std::size_t thread) {
    for (std::size_t number = 0; number != finished;) {
      Done done;
      for (std::size_t p = thread; p < parts_.size(); p += threads_) take(p, number, done);
      finish(done, number);
      if (!ends_soon(number))
        for (std::size_t p = 0; p < parts_.size(); ++p) {  // what others have not begun
          done = {};
          take(p, number, done);
          finish(done, number);
        }
      number = spin_wait(now_.number, [number](std::size_t now) { return now != number; });
    }
  }

  // To work on another thread's parts moves their numbers from cache to cache: that is for late ones.
  bool ends_soon(std::size_t number) const {
    constexpr int spins = 50'000;
    for (int spin = 0; spin < spins; ++spin)
      if (now_.number.load(std::memory_order_acquire) != number) return true;
    return false;
  }

  void take(std::size_t p, std::size_t number, Done& done) {
    std::size_t before = number;
    if (parts_[p].taken.load(std::memory_order_relaxed) != number ||
        !parts_[p].taken.compare_exchange_strong(before, number + 1, std::memory_order_acq_rel))
      return;
    const std::size_t unsettled = work_(p, PassInTurn{now_.passes[number % 2], now_.passes[(number + 1) % 2], number});
    done.unsettled = std::min(done.unsettled, static_cast<std::uint32_t>(unsettled));
    ++done.parts;
  }

  void finish(const Done& done, std::size_t number) {
    if (done.parts == 0) return;
    std::uint64_t all = done_.load(std::memory_order_relaxed), sum;
    do sum = together(all, done);
    while (!done_.compare_exchange_weak(all, sum, std::memory_order_acq_rel));
    if ((sum >> 32U) < parts_.size()) return;
    // The last part is done, and all others wait.
    const std::optional<Pass> following = next_(now_.passes[number % 2], static_cast<std::uint32_t>(sum));
    if (following) now_.passes[(number + 1) % 2] = *following;
    done_.store(none_done, std::memory_order_relaxed);
    now_.number.store(following ? number + 1 : finished, std::memory_order_release);
    now_.number.notify_all();
  }

  std::size_t threads_;
  const Work& work_;
  Next& next_;
  std::vector<Part> parts_;
  alignas(64) std::atomic<std::uint64_t> done_{none_done};  // of this pass, as together() has it
  struct alignas(64) Now {
    std::atomic<std::size_t> number{0};                  // of this pass
    std::array<Pass, 2> passes{Pass{0, 0}, Pass{0, 0}};  // those with even numbers, those with odd ones
  } now_;
};

// The same in one call.
template <class Work, class Next>
void passes_side_by_side(std::size_t parts, std::size_t threads, const Pass& first, const Work& work, Next next) {
  PassesSideBySide<Work, Next>(parts, std::max<std::size_t>(threads, 1), work, next).run(first);
}

}  // namespace waymark::plan
