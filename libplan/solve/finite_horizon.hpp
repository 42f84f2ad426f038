// Costs of the first steps of a run, by dynamic programming backwards in time [Bel57, Ch. XI].
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct Horizon {               // a question about costs
  std::uint64_t steps = 0;     // of the run
  bool instantaneous = false;  // what the choice after the steps costs; else what the steps cost together
  bool greatest = false;       // over all strategies; else the least
  double discount = 1;         // what a step later counts less by
};

// The expected cost, exact up to the rounding of a sum. O(steps · outcomes). nullopt: stopped.
std::optional<double> expected_cost(const Mdp& mdp, const Horizon& horizon, const std::stop_token& stop = {});

}  // namespace waymark::plan
