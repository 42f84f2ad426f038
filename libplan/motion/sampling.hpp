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
  std::uint64_t seed = 1;
  Robot robot = Disc{};
  Sampler sampler = Sampler::InformedRrtStar;
};
SamplingBudget sampling_budget(const Sampling& sampling, std::size_t leg);  // every leg has a seed of its own

struct Unreached {  // nothing proved: a leg for which no path was found
  PoseId from, to;
  std::size_t iterations = 0;  // spent on it
};
using Realization = std::variant<Motion, Unreached>;

}  // namespace waymark::plan
