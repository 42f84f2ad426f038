// A hand of a farm: the texts that a giver gives, and the way back of the replies.
#pragma once
#include <chrono>
#include <mutex>
#include <optional>
#include <vector>

#include "tools/shell/dealt_texts.hpp"
#include "tools/shell/packed.hpp"
#include "tools/shell/seat.hpp"

namespace waymark::tools {

class HandTexts {
 public:
  explicit HandTexts(const Seat& seat) : seat_(seat) {}

  std::optional<DealtText> next();  // from one thread at a time; waits; nullopt: the giver is gone
  void put(const Reply& reply);     // in the order of the texts, from one thread at a time

 private:
  using Clock = std::chrono::steady_clock;
  bool is_over() const { return Clock::now() >= end_; }
  void take(const std::string& chunk);
  void say(bool over);  // what was answered since the last time
  void say_when_over();

  Seat seat_;
  std::mutex mutex_;  // over all below
  std::uint64_t chunk_ = 0;
  Clock::time_point begun_, end_;
  std::vector<Text> texts_;
  std::size_t taken_ = 0, answered_ = 0;
  bool closed_ = true;  // no text of this chunk will be taken any more
  bool said_over_ = true;
  Packed replies_;
  std::size_t unsaid_ = 0;
};

}  // namespace waymark::tools
