// Seconds and bytes as a stop: a Watch requests a stop when one of them is used up. Whatever takes Limits (limits.hpp)
// and polls their stop so has all four limits of a budget: states, seconds, bytes, and the caller's own stop.
#pragma once
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <thread>

namespace waymark::ltl {

struct Allowance {        // of one piece of work
  double seconds = 0;     // 0: any
  std::size_t bytes = 0;  // of memory that the process holds, other work's included; 0: any
};

enum class Overrun : std::uint8_t { None, Time, Memory };  // which allowance was used up

class Watch {
 public:
  // A thread of its own where there is an allowance to watch; bytes are looked at every five milliseconds.
  Watch(const Allowance& allowance, std::stop_token also);
  std::stop_token token() const { return stop_.get_token(); }  // stops when `also` does, or when a limit is met
  Overrun overrun() const { return overrun_; }                 // None when the other stop came first

 private:
  struct Forward {
    std::stop_source* to;
    void operator()() const { to->request_stop(); }
  };
  void keep(const Allowance& allowance, const std::stop_token& over);

  std::stop_source stop_;
  std::atomic<Overrun> overrun_ = Overrun::None;
  std::stop_callback<Forward> forward_;
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread keeper_;  // last: joined before what it uses is gone
};

// Resident memory of this process that no file stands behind, in bytes: RssAnon of /proc/self/status, proc(5). Memory
// that was freed counts until the allocator gives it back. Throws std::runtime_error where the system does not tell.
// Some ten microseconds.
std::size_t memory_held();

}  // namespace waymark::ltl
