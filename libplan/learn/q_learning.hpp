// Q-learning in tables, and what knowing the task adds to it.
//
//   Q(s, a) ← Q(s, a) + α (r + γ max over a′ of Q(s′, a′) − Q(s, a))        r = 1 on acceptance, else 0     [WD92]
// α is n^−decay for the n-th update of Q(s, a): 1 on a deterministic model, where one look tells all, and decay 0.77 on
// a noisy one. [EDM03]
// Tables begin at an upper bound of what they can hold ("optimism under uncertainty", [SB18, Sec. 2.6]), so that a
// learner who acts greedily tries what it has not tried. Variants, which can be combined:
//   counterfactual  what was seen, (position, action, position, letter), is an experience for every state of the
//                   automaton: all of them are updated. [TKVM22, Sec. 3.2]
//   shaped          r + γ Φ(s′) − Φ(s) in the place of r, Φ(s) = γ^(d − 1) for d letters from s's task to acceptance
//     and
//                   0 where the task has ended: leaves the best policies as they are [NHR99, Th. 1]. Φ is itself an
//                     upper
//                   bound, so tables then begin at 0, which means Φ. [Wie03]
//   curriculum      one value function for each progressed formula, all learnt off policy from every step as LPOPL
//     does;
//                   episodes are given the sub-tasks in turn, easiest first, and each until it has been solved
//                   `passes` times in a row. [TKVM18]
//   replays         past experiences updated again after every step, evenly drawn from the last `memory`. [Lin92]
#pragma once
#include <optional>

#include "libplan/learn/training.hpp"

namespace waymark::plan {

struct QLearning {
  // The variants above.
  bool counterfactual = false, shaped = false, curriculum = false;
  std::size_t replays = 0;           // past experiences updated again after every step
  std::size_t memory = 25'000;       // how many experiences replays draw from
  std::size_t passes = 2;            // of the curriculum: successes in a row that solve a sub-task
  std::optional<double> decay = {};  // unset: 0 on a deterministic model, else 0.77
  bool optimistic = true;            // else tables begin at 0, or −Φ
};

struct QTable {                // what was learnt
  std::vector<double> values;  // by state · actions + action; −∞ where the action is not offered
  LearningCurve curve;         // of the run
};

// Throws std::invalid_argument when the product is over at every start.
QTable learn(const TabularProduct& product, const QLearning& method, const Training& training);

// The first best action of each open state.
ActionTable greedy(const TabularProduct& product, const std::vector<double>& values);

// Φ by task, as above.
std::vector<double> potential(const TaskRows& task, double discount);

}  // namespace waymark::plan
