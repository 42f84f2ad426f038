#include "libltl/watch.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace waymark::ltl {

Watch::Watch(const Allowance& allowance, std::stop_token also) : forward_(std::move(also), Forward{&stop_}) {
  if (allowance.seconds <= 0 && allowance.bytes == 0) return;
  keeper_ = std::jthread([this, allowance](const std::stop_token& over) { keep(allowance, over); });
}

void Watch::keep(const Allowance& allowance, const std::stop_token& over) {
  using Clock = std::chrono::steady_clock;
  using Pause = std::chrono::duration<double>;
  constexpr Pause between_looks = std::chrono::milliseconds(5);
  const auto begin = Clock::now();
  std::unique_lock lock(mutex_);
  for (Overrun overrun = Overrun::None; !stop_.stop_requested();) {
    const Pause left = Pause(allowance.seconds) - (Clock::now() - begin);
    if (allowance.bytes > 0 && memory_held() > allowance.bytes) overrun = Overrun::Memory;
    if (allowance.seconds > 0 && left <= Pause(0)) overrun = Overrun::Time;
    if (overrun != Overrun::None) {
      overrun_ = overrun;
      stop_.request_stop();
      return;
    }
    const Pause pause = allowance.bytes == 0    ? left
                        : allowance.seconds > 0 ? std::min(left, between_looks)
                                                : between_looks;
    woken_.wait_for(lock, over, pause, [] { return false; });
    if (over.stop_requested()) return;
  }
}

std::size_t memory_held() {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
    if (word == "RssAnon:") {
      std::size_t kibibytes = 0;
      file >> kibibytes;
      if (file) return kibibytes << 10U;
    }
  throw std::runtime_error("/proc/self/status does not say how much memory is held");
}

}  // namespace waymark::ltl
