// A referee of values on models: two bounds of an optimum over the pairs of progression_product.hpp, each proved by
// Bellman's equations, without end components and without the solvers.
//
// From below: sweeps from 0 on raise what is at most the least solution [BK08, Thm. 10.100]. From above: numbers that a
// sweep does not raise are at least the least solution [HK20]; the numbers tried are those from below, a little more. A
// least cost is bounded from above by a strategy that goes to the goal.
#pragma once
#include <cmath>
#include <cstdint>
#include <stop_token>

#include "tools/progression_product.hpp"

namespace waymark::tools {

enum class Optimum : std::uint8_t { GreatestProbability, LeastProbability, LeastCost, GreatestCost };

struct Bracket {  // of an optimum, up to the rounding of doubles
  double below = 0, above = INFINITY;
};

// Of the probability to come to a goal, or of the expected cost until then, which is infinite where the goal may be
// missed. The bounds are apart where a million sweeps do not suffice.
Bracket bracket(const ProgressionProduct& product, Optimum what, const std::stop_token& stop);

}  // namespace waymark::tools
