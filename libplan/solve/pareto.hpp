// Two objectives at once of a Markov decision process: what pairs of values strategies attain. [EKVY07] [FKP12]
//
// An objective is the probability of a formula that a finite prefix decides, or an expected total cost. The product of
// the model with the automata of the formulas makes both of them total rewards, and a weighted sum of the two is again
// one: policy iteration finds the strategy that is best for the weights. The points of the strategies for the weights
// between neighbours are the vertices of the convex set that randomised strategies attain, and every weighted optimum
// bounds that set from outside. A vertex has a strategy without memory on the product, which is re-evaluated as a
// Markov chain by value iteration.
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "libplan/model/mdp.hpp"
#include "libplan/solve/decide.hpp"

namespace waymark::plan {

struct Objective {        // of a strategy
  std::string formula;    // its probability; empty: a cost
  const Mdp* costs = {};  // of a cost: the model with these costs, its total over a run
  bool greatest = true;   // is more better?
};

struct ParetoDecision {     // of a strategy
  std::uint32_t state = 0;  // of the model
  std::string action;       // what to do there
  std::string memory;       // states of the automata of the formulas: "" where there are none
};

struct ParetoPoint {                      // of a strategy
  std::vector<double> values;             // by objective
  std::vector<Bounds> re_evaluated;       // as a Markov chain
  std::vector<ParetoDecision> decisions;  // in the states that it meets, breadth first; those without end included
};

struct Pareto {
  std::vector<ParetoPoint> points;  // vertices that no other point is better than, by the first objective, ascending
  std::uint64_t solutions = 0;      // of weighted sums
};

// Of one or two objectives. No points: every strategy has infinite costs. nullopt: stopped. Vertices are found whose
// distance from the segment between their neighbours exceeds the precision, relative to the values. Throws
// std::invalid_argument for a formula that no finite prefix decides and for a cost that may be infinite and is to be
// great; std::logic_error where a re-evaluation differs.
std::optional<Pareto> pareto(const Mdp& model, const std::vector<Objective>& objectives, double precision = 1e-6,
                             const std::stop_token& stop = {});

}  // namespace waymark::plan
