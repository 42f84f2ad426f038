#include "libplan/learn/replay.hpp"

#include <algorithm>

namespace waymark::plan {

std::size_t Replay::add(const Experience& experience) {
  if (experiences_.size() < experiences_.capacity()) {
    experiences_.push_back(experience);
    return experiences_.size() - 1;
  }
  const std::size_t place = oldest_;
  experiences_[place] = experience;
  oldest_ = (oldest_ + 1) % experiences_.size();
  return place;
}

Priorities::Priorities(std::size_t capacity) {
  while (leaves_ < capacity) leaves_ *= 2;
  sums_.assign(2 * leaves_, 0);
}

void Priorities::set(std::size_t place, double priority) {
  greatest_ = std::max(greatest_, priority);
  std::size_t node = leaves_ + place;
  sums_[node] = priority;
  for (node /= 2; node > 0; node /= 2) sums_[node] = sums_[2 * node] + sums_[2 * node + 1];
}

std::size_t Priorities::draw(ltl::Random& random) const {
  double rest = random.unit() * sum();
  std::size_t node = 1;
  while (node < leaves_) {
    node *= 2;
    if (rest >= sums_[node] && sums_[node + 1] > 0) rest -= sums_[node++];
  }
  return node - leaves_;
}

}  // namespace waymark::plan
