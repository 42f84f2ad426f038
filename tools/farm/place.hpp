// A hand's place at a rank: a process that answers chunks, started again whenever it is killed.
#pragma once
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

  void give(std::string_view chunk);  // to be answered; one at a time
  void look();
  std::uint64_t chunk() const { return chunk_; }  // number of what it is at work on; 0: none
  void add_to(std::vector<pollfd>& pipes) const;

 private:
  void start();
  void hear();

  std::string program_;
  std::vector<std::string> arguments_;
  Tell tell_;
  std::unique_ptr<Child> child_;  // none: it ended by itself, or was killed too often
  std::uint64_t chunk_ = 0;
  int fruitless_ = 0;  // times that it was killed since it last answered something
};

}  // namespace waymark::tools
