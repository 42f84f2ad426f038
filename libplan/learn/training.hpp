// The parameters of training that all learners share, and the learning curve that they return.
//
// A learner takes `steps` steps in the environment. Every `interval` steps it is interrupted, and the policy that it
// would follow now, without exploring, is solved exactly: learning curves carry values, not averages of a few episodes.
// Exploration is ε-greedy: ε falls in a straight line from `explore` to `explore_last` over the first
// `explore_steps` steps.
#pragma once
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "libplan/learn/policy_value.hpp"

namespace waymark::plan {

struct Training {
  std::size_t steps = 20'000;                // of the environment
  std::size_t interval = 100;                // steps between checkpoints
  std::size_t horizon = 500;                 // steps of an episode before it is cut
  double discount = 0.9;                     // γ
  double explore = 0.1, explore_last = 0.1;  // ε at first and at last
  std::size_t explore_steps = 0;             // until ε has its last value
  std::uint64_t seed = 1;                    // of all randomness
  std::stop_token stop = {};                 // looked at in every interval; the curve then ends early

  double epsilon(std::size_t step) const {  // linear from the first value to the last
    if (step >= explore_steps) return explore_last;
    return explore + (explore_last - explore) * static_cast<double>(step) / static_cast<double>(explore_steps);
  }
};

// The loop of every learner: act(step) for each step, checkpoint(steps taken) in every interval and at the end.
template <class Act, class Judge>
void take_steps(const Training& training, Act&& act, Judge&& checkpoint) {
  std::size_t step = 0;
  for (; step < training.steps; ++step) {
    if (step % training.interval == 0) {
      if (training.stop.stop_requested()) break;
      checkpoint(step);
    }
    act(step);
  }
  checkpoint(step);
}

struct Checkpoint {       // a policy on the way
  std::size_t steps = 0;  // taken so far
  PolicyValue value;      // exact
};

struct LearningCurve {                  // what a run returns
  std::vector<Checkpoint> checkpoints;  // the first before the first step, the last after the last one
  std::size_t updates = 0;              // of single values, or of the network
  std::size_t episodes = 0;             // begun
  ActionTable policy;                   // of DQN: what the network would do in the end, by state
};

}  // namespace waymark::plan
