#include "tools/shell/deadline.hpp"

#include <chrono>

namespace waymark::tools {

Deadline::Deadline(double seconds, std::stop_token also) : forward_(std::move(also), Forward{&stop_}) {
  if (seconds <= 0) return;
  timer_ = std::jthread([this, seconds](const std::stop_token& over) {
    std::unique_lock lock(mutex_);
    woken_.wait_for(lock, over, std::chrono::duration<double>(seconds), [] { return false; });
    if (over.stop_requested()) return;
    passed_ = !stop_.stop_requested();
    stop_.request_stop();
  });
}

}  // namespace waymark::tools
