// Hierarchical Q-learning: an option for each proposition of the task, and a controller that chooses among them.
//
// The option of p walks, by its own table over positions, until a letter carries p; all options learn off policy from
// every step. It also ends where the task moves on, and after `patience` steps. The controller's table is over the
// product; an option that ran for k steps is one experience of it: reward γ^(k−1) on acceptance, else γᵏ times the best
// that follows. [SPS99, Sec. 3]
// What comes out is a best way of using these options, not a best policy: the option of p takes the nearest p, and pays
// no regard to what must be avoided on the way. Policies are solved exactly, as chains over (product, option);
// there an option that never arrives never ends.
#pragma once
#include <optional>

#include "libplan/learn/training.hpp"

namespace waymark::plan {

struct Hierarchical {
  std::size_t patience = 50;
  std::optional<double> decay = {};  // as in q_learning.hpp
};

// Throws std::invalid_argument when the product is over at every start.
LearningCurve learn(const TabularProduct& product, const Hierarchical& method, const Training& training);

}  // namespace waymark::plan
