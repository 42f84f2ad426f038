// A hand's place at a rank: a process that answers chunks, started again whenever it is killed.
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/farm/child.hpp"
#include "tools/shell/seat.hpp"

namespace waymark::tools {

class Place {
 public:
  // `tell`: news of this place, without the number of the hand, as Packed: kind, then the rest (seat.hpp).
  using Tell = std::function<void(FarmNews, const std::string& rest)>;
  Place(std::string program, std::vector<std::string> arguments, Tell tell);

  void give(std::string_view chunk);  // to be answered after those before it
  void look();
  bool is_idle() const { return chunks_.empty(); }
  void add_to(std::vector<pollfd>& pipes) const;

 private:
  void start();
  void hear();

  std::string program_;
  std::vector<std::string> arguments_;
  Tell tell_;
  std::unique_ptr<Child> child_;      // none: it ended by itself, or was killed too often
  std::deque<std::uint64_t> chunks_;  // numbers; it is at work on the first
  int fruitless_ = 0;                 // times that it was killed since it last answered something
};

}  // namespace waymark::tools
