// The best that a learner can come to: the solvers' sweeps (solve/discounted_sweeps.hpp) for the discounted return that
// all learners maximise, over the product that they step in.
//
// On a deterministic model that is γ^(n−1) for the fewest actions n, so the best policy is a route of least cost where
// every action costs the same. With γ < 1 the sweeps end when no value is further than `tolerance` (relative) from V.
#pragma once
#include "libplan/learn/policy_value.hpp"

namespace waymark::plan {

struct Optimum {
  ActionTable policy;      // the first best action of each state; no_action where nothing is to be gained
  PolicyValue value;       // of that policy, from the linear systems
  std::size_t sweeps = 0;  // until the values were within the tolerance
};

struct OptimumOptions {            // of the reference
  double discount = 0.9;           // γ
  double tolerance = 1e-12;        // of values
  std::size_t sweeps = 1'000'000;  // a limit, for a discount of 1
};

// Sweeps until no value changes by more than the tolerance, or the limit is met.
Optimum optimum(const TabularProduct& product, const OptimumOptions& options = {});

}  // namespace waymark::plan
