// Deep Q-learning: the table of Q-learning replaced by a perceptron over what is seen and what is still to be done.
//
//   input    distances from the pose (observations.hpp), then the task: one-hot over the states of the automaton, or
//            the vector that a recursive encoder makes of the progressed formula
//   network  2 hidden layers of 64 ReLUs, one output for each action
//   target   y = 1 on acceptance, 0 in a trap, γ max over a′ of Q⁻(s′, a′) otherwise; Q⁻ is copied every 100 steps
//   update   one a step, as soon as there is a batch: 32 experiences out of the last 25,000, the error Q − y cut to
//            [−1, 1], Adam with rate 1e-4                                                           [MKS+15, Alg. 1]
// Options: the action of the target chosen by Q and valued by Q⁻ [HGS16]; experiences drawn by priority [SQAS16].
// Where the action is not offered its output is passed over.
//
// Without an encoder nothing is allocated in a step. Q⁻ of a state is computed once for each copy, when a batch first
// asks for it: on a product of a few hundred states that saves most of a forward pass.
#pragma once
#include <vector>

#include "libplan/learn/q_network.hpp"
#include "libplan/learn/training.hpp"

namespace waymark::plan {

struct Dqn {
  std::vector<neural::Index> hidden{64, 64};  // widths of the hidden layers
  double rate = 1e-4;                         // of Adam
  // Experiences of an update; experiences that are kept; steps between copies of the target network.
  std::size_t batch = 32, memory = 25'000, copy = 100;
  bool double_q = false;     // actions by one network, their values by the other
  bool prioritised = false;  // experiences are drawn by their errors
  double priority_exponent = 0.6,
         weight_exponent = 0.4;   // the latter rises to 1 in the course of the training
  neural::Index task_width = 16;  // of the encoder's vectors
};

// Throws std::invalid_argument when the product is over at every start, or the input is not that of its positions.
LearningCurve learn(const TabularProduct& product, const DqnInput& input, const Dqn& method, const Training& training);

}  // namespace waymark::plan
