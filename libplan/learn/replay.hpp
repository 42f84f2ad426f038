// Experience replay: the last so many experiences, drawn evenly or by priority.
//
// Prioritised: an experience is drawn with probability pᵢ / Σ p, p = (|error| + small)^α when it was last used, and the
// greatest priority so far when it is new. A draw comes with the weight (N · Pr(i))^(−β) / (the greatest weight) that
// undoes the bias. Sums of priorities stand in a binary tree, so that a draw costs O(log N). Source: [SQAS16, Alg. 1].
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "libltl/structure/random.hpp"

namespace waymark::plan {

struct Experience {                                  // one step, as it is kept
  std::uint32_t position = 0, task = 0, action = 0;  // where, owing what, what was done
  std::uint32_t next = 0, letter = 0;                // the position it led to, and the letter read on the way
};

class Replay {  // a ring
 public:
  explicit Replay(std::size_t capacity) { experiences_.reserve(capacity); }

  std::size_t size() const { return experiences_.size(); }
  std::size_t add(const Experience& experience);  // its place; the oldest gives way
  const Experience& operator[](std::size_t place) const { return experiences_[place]; }
  const Experience& draw(ltl::Random& random) const { return experiences_[random.below(size())]; }  // evenly

 private:
  std::vector<Experience> experiences_;
  std::size_t oldest_ = 0;
};

// Priorities by place of a Replay.
class Priorities {
 public:
  explicit Priorities(std::size_t capacity);
  void set(std::size_t place, double priority);                          // at least 0
  double of(std::size_t place) const { return sums_[leaves_ + place]; }  // as it was set
  double greatest() const { return greatest_; }                          // ever set, at least 1
  double sum() const { return sums_[1]; }                                // of all
  std::size_t draw(ltl::Random& random) const;                           // with probability of(place) / sum()

 private:
  std::size_t leaves_ = 1;
  std::vector<double> sums_;  // a heap: node i over 2i and 2i + 1, the leaves are the priorities
  double greatest_ = 1;
};

}  // namespace waymark::plan
