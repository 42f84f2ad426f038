// Searches by several threads: each works on its own queue, and who has none left gets half of another's.
//
// What such a search finds must not depend on its order: a set that grows until nothing joins it.
#pragma once
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <vector>

#include "libltl/parallel.hpp"

namespace waymark::plan {

template <class Item>
class SharedWork {
 public:
  bool wanted() const { return hungry_.load(std::memory_order_relaxed) > 0; }  // does a thread wait?
  void give(std::deque<Item>& own) {                                           // the later half of a queue
    constexpr std::size_t least = 64;  // to hand over less takes longer than to do it
    if (own.size() < 2 * least) return;
    const std::lock_guard lock(mutex_);
    const auto middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    pool_.insert(pool_.end(), middle, own.end());
    own.erase(middle, own.end());
    given_.notify_one();
  }

  void begin() {  // by every thread, before it looks for work elsewhere
    const std::lock_guard lock(mutex_);
    ++working_;
  }
  // Waits. False: all threads that have begun are here, and there is nothing to do.
  bool take(std::deque<Item>& own) {
    std::unique_lock lock(mutex_);
    --working_;
    ++hungry_;
    if (working_ == 0 && pool_.empty()) end();
    given_.wait(lock, [this] { return done_ || !pool_.empty(); });
    --hungry_;
    if (done_) return false;
    ++working_;
    own.swap(pool_);
    return true;
  }
  void abandon() {  // where a thread gives up, the others need not wait for it
    const std::lock_guard lock(mutex_);
    end();
  }

 private:
  void end() {
    done_ = true;
    given_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable given_;
  std::deque<Item> pool_;
  std::size_t working_ = 0;  // have begun and do not wait
  bool done_ = false;
  std::atomic<std::size_t> hungry_{0};
};

// begin(range, put): for each of so many ranges, by any thread. expand(item, put, thread) -> bool: for each item that
// was put, once; first come, first served by each thread. put(item) is called for what was found anew: of several
// threads that find it at once, by one. Once expand says false nothing is expanded any more, and the answer is false.
template <class Item, class Begin, class Expand>
bool search_together(std::size_t ranges, std::size_t threads, const Begin& begin, const Expand& expand) {
  SharedWork<Item> shared;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> going{true};
  const auto work = [&](std::size_t, std::size_t thread) {
    std::deque<Item> own;
    const auto put = [&own](const Item& item) { own.push_back(item); };
    const auto stop = [&] {
      going = false;
      shared.abandon();
    };
    const auto empty_own = [&] {
      while (!own.empty()) {
        const Item item = own.front();
        own.pop_front();
        if (!going.load(std::memory_order_relaxed)) return;
        if (!expand(item, put, thread)) return stop();
        if (shared.wanted()) shared.give(own);
      }
    };
    try {
      shared.begin();
      for (std::size_t range = next++; range < ranges && going; range = next++) {
        begin(range, put);
        empty_own();
      }
      while (going && shared.take(own)) empty_own();
    } catch (...) {
      stop();
      throw;
    }
  };
  ltl::parallel_for(threads, threads, work);
  return going;
}

}  // namespace waymark::plan
