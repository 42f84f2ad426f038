// Gauss–Seidel sweeps by several threads, with the numbers of one thread to the last bit.
//
// A sweep goes over chunks in order and uses what it has written before. The next sweep follows it at a distance: it
// works on a chunk once the sweep before has left all chunks whose numbers go with this one's. So every number is made
// of the same numbers as if one sweep had waited for the other. A pass is a sweep over some of the chunks; the next one
// is known as soon as a chunk has not settled, since then there must be one.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

#include "libltl/parallel.hpp"

namespace waymark::plan {

// By chunk, the last chunk whose numbers go with its own, itself among them.
class ChunkReach {
 public:
  explicit ChunkReach(std::size_t chunks) : last_(chunks) {
    for (std::size_t c = 0; c < chunks; ++c) last_[c] = c;
  }
  void relate(std::size_t a, std::size_t b) {  // a number of one is made of a number of the other
    std::size_t& last = last_[std::min(a, b)];
    last = std::max(last, std::max(a, b));
  }
  std::size_t operator[](std::size_t chunk) const { return last_[chunk]; }
  std::size_t chunks() const { return last_.size(); }  // how many there are

 private:
  std::vector<std::size_t> last_;
};

struct Pass {                  // over the chunks with begin ≤ chunk < end
  std::size_t begin = 0, end;  // chunks
  double factor = 1;           // for the work
  bool anew = false;           // of other numbers than the pass before it: parts take nothing from that one
};

// Waits until the number is enough: for some microseconds awake, then asleep. What it is then.
template <class Enough>
std::size_t spin_wait(std::atomic<std::size_t>& number, const Enough& enough) {
  constexpr int spins = 100'000;  // some microseconds: about a chunk
  std::size_t now = number.load(std::memory_order_acquire);
  for (int spin = 0; !enough(now); now = number.load(std::memory_order_acquire)) {
    if (++spin < spins) continue;
    number.wait(now, std::memory_order_acquire);
    spin = 0;
  }
  return now;
}

// Runs `first` and what follows it.
//   work(chunk, pass) -> bool: has the chunk settled? Touches numbers of the chunk, and reads what it is related to.
//   next(pass, unsettled) -> optional<Pass>: what follows a pass whose first unsettled chunk this is (pass.end: none);
//     called once a pass, in their order, never at the same time; nothing: it was the last.
// Memory: O(threads).
template <class Work, class Next>
class PipelinedPasses {
 public:
  PipelinedPasses(const ChunkReach& reach, std::size_t threads, const Work& work, Next& next)
      : reach_(reach), threads_(threads), work_(work), next_(next), slots_(2 * threads + 2) {}

  void run(const Pass& first) {  // until there are no more
    publish(0, first);
    ltl::parallel_for(threads_, threads_, [this](std::size_t, std::size_t) { run_passes(); });
  }

 private:
  static constexpr std::size_t finished = SIZE_MAX, none = SIZE_MAX;
  struct Slot {
    Pass pass;
    std::atomic<std::size_t> done{0};  // this pass and those before it have left the chunks before this one
  };
  Slot& slot(std::size_t number) { return slots_[number % slots_.size()]; }

  void publish(std::size_t number, const Pass& pass) {
    Slot& own = slot(number);
    own.pass = pass;
    own.done.store(0, std::memory_order_relaxed);
    published_.store(number + 1, std::memory_order_release);
    published_.notify_all();
  }

  // Takes pass after pass until there are no more. A thread alone does them all.
  void run_passes() {
    for (std::size_t number = taken_++; known(number); number = taken_++) run_pass(number);
  }

  bool known(std::size_t number) {
    return spin_wait(published_, [&](std::size_t published) { return published > number; }) != none;
  }

  // The pass that follows, or none.
  void decide(std::size_t number, std::size_t unsettled) {
    if (const std::optional<Pass> following = next_(slot(number).pass, unsettled)) {
      publish(number + 1, *following);
    } else {
      published_.store(none, std::memory_order_release);
      published_.notify_all();
    }
  }

  // Passes finish in their order. So those at work are neighbours, and the slot of a new one is that of a pass which
  // neither its own thread nor that of its follower will look at again.
  void run_pass(std::size_t number) {
    Slot& own = slot(number);
    const Pass pass = own.pass;
    bool decided = false;
    for (std::size_t chunk = pass.begin; chunk < pass.end; ++chunk) {
      if (number > 0)
        spin_wait(slot(number - 1).done, [last = reach_[chunk]](std::size_t done) { return done > last; });
      const bool settled = work_(chunk, pass);
      own.done.store(chunk + 1, std::memory_order_release);
      own.done.notify_all();
      if (settled || decided) continue;
      decided = true;
      decide(number, chunk);
    }
    if (number > 0) spin_wait(slot(number - 1).done, [](std::size_t done) { return done == finished; });
    own.done.store(finished, std::memory_order_release);
    own.done.notify_all();
    if (!decided) decide(number, pass.end);
  }

  const ChunkReach& reach_;
  std::size_t threads_;
  const Work& work_;
  Next& next_;
  std::vector<Slot> slots_;
  std::atomic<std::size_t> taken_{0}, published_{0};
};

// The same in one call.
template <class Work, class Next>
void pipelined_passes(const ChunkReach& reach, std::size_t threads, const Pass& first, const Work& work, Next next) {
  PipelinedPasses<Work, Next>(reach, std::max<std::size_t>(threads, 1), work, next).run(first);
}

}  // namespace waymark::plan
