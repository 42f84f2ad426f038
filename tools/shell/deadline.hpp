// A stop that comes by itself after some seconds, or with another stop, whichever is first.
#pragma once
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace waymark::tools {

class Deadline {
 public:
  Deadline(double seconds, std::stop_token also);  // seconds = 0: only the other stop
  std::stop_token token() const { return stop_.get_token(); }
  bool passed() const { return passed_; }  // the time ran out (and the other stop was not requested)

 private:
  struct Forward {
    std::stop_source* to;
    void operator()() const { to->request_stop(); }
  };
  std::stop_source stop_;
  std::atomic<bool> passed_ = false;
  std::stop_callback<Forward> forward_;
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread timer_;  // last: joined before what it uses is gone
};

}  // namespace waymark::tools
