// Expected discounted costs of a decision process without a task: Σ γᵗ cost(t) over all steps t ≥ 0 [Put94, Sec. 6.2].
#pragma once
#include <optional>
#include <stop_token>
#include <vector>

#include "libplan/model/mdp.hpp"
#include "libplan/solve/decide.hpp"

namespace waymark::plan {

struct DiscountedCosts {         // a question
  double discount = 0;           // γ, 0 ≤ γ < 1
  bool greatest = false;         // over all strategies; else the least
  std::vector<bool> ended = {};  // by state: nothing is paid from there on; or empty
};

// Of the initial state, between bounds no further apart than the tolerance (times the value, where that is more than
// 1) or than rounding lets them be. O(outcomes) a sweep, and log(tolerance) / log γ sweeps. nullopt: stopped.
std::optional<Bounds> discounted_cost(const Mdp& mdp, const DiscountedCosts& asked, double tolerance,
                                      const std::stop_token& stop = {});

}  // namespace waymark::plan
