// The options of the conversion of a route to a motion, and its outcome.
#pragma once
#include <cstddef>
#include <cstdint>
#include <variant>

#include "libplan/motion/motion.hpp"
#include "libplan/motion/ompl_bridge.hpp"

namespace waymark::plan {

struct Sampling {
  std::size_t iterations = 1'000;  // for each leg that is sampled; no clock, so equal seeds give equal bytes
  std::uint64_t seed = 1;          // of the sampling
  Robot robot = Disc{};            // that moves
  Sampler sampler = Sampler::InformedRrtStar;  // which planner
};
SamplingBudget sampling_budget(const Sampling& sampling, std::size_t leg);  // every leg has a seed of its own

struct Unreached {             // nothing proved: a leg for which no path was found
  PoseId from, to;             // the ends of the leg
  std::size_t iterations = 0;  // spent on it
};
using Realization = std::variant<Motion, Unreached>;  // a motion, or the leg that was not found

}  // namespace waymark::plan
