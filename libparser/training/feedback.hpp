// The feedback that a program earns from a trajectory, in [0, 1]: the kinds of network_options.hpp.
//
// From an unknown heading a trajectory stands for four, one for each heading at its start, each with the fewest turns
// to the first heading that is known: progression gives their mean. The other trajectories are random walks of the same
// length, drawn once for each sentence.
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "libltl/meaning/trace_check.hpp"
#include "libparser/model/network_options.hpp"
#include "libparser/supervision/examples.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::parser {

class Feedback {
 public:
  // The executors must outlive it. One for each thread.
  Feedback(std::span<const Executor> executors, FeedbackKind kind, Then then, std::uint64_t seed)
      : executors_(executors), kind_(kind), then_(then), seed_(seed) {}

  double of(const Program& program, const Example& example);  // of the program for this sentence
  const Executor& executor(const Example& example) const { return executors_[example.map]; }  // of the sentence's map

 private:
  struct Words {
    std::vector<ltl::Columns> gold, prefixes, others;
  };
  const Words& words_of(const Example& example);

  std::span<const Executor> executors_;
  FeedbackKind kind_;
  Then then_;
  std::uint64_t seed_;
  std::unordered_map<const Example*, Words> words_;
};

// The trajectories that a gold route from an unknown heading stands for: one for each of the four headings.
std::vector<plan::Trajectory> trajectories_of(const GoldRoute& gold, const plan::Map& map);

}  // namespace waymark::parser
