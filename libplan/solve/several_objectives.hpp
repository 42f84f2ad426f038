// One objective of a Markov decision process under a bound on another, and what is infinite or not to be had there.
//
// The graph decides first: whether a reward that is to be great can be earned for ever, and whether a cost that is to
// be small can be kept finite, by strategies that also meet the bound. What is left is read off the curve of
// pareto.hpp. Strategies may draw lots, so values lie between those of two strategies. A least upper bound that only
// ever smaller chances come near counts as the value.
#pragma once
#include <optional>
#include <stop_token>
#include <vector>

#include "libplan/solve/pareto.hpp"

namespace waymark::plan {

struct BoundedObjective {       // of a strategy
  Objective objective;          // what counts
  std::optional<double> bound;  // that it must reach: at least where it is to be great, at most where it is to be small
};

struct SeveralAnswer {              // of one or two objectives
  enum class Kind : std::uint8_t {  // what is told
    Curve,                          // nothing is bounded, and there are two: `curve`
    Value,                          // the best value under the bounds, which may be infinite
    Truth,                          // all is bounded: whether one strategy meets them, 1 or 0
    Infeasible,                     // no strategy meets the bound
  };
  Kind kind = Kind::Curve;              // of this answer
  double value = 0;                     // a Value, or a Truth
  std::vector<ParetoPoint> curve = {};  // of the strategies whose costs are finite
};

// Of one or two objectives. nullopt: stopped. Throws std::invalid_argument as pareto, and for a reward that is to be
// great where strategies earn it for ever, but none that meets the bound.
std::optional<SeveralAnswer> several_objectives(const Mdp& model, const std::vector<BoundedObjective>& objectives,
                                                double precision = 1e-6, const std::stop_token& stop = {});

}  // namespace waymark::plan
