#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

SamplingBudget sampling_budget(const Sampling& sampling, std::size_t leg) {  // SplitMix64 [SLF14]
  std::uint64_t z = sampling.seed + 0x9E3779B97F4A7C15ULL * (leg + 1);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return {sampling.sampler, sampling.iterations, static_cast<std::uint32_t>((z ^ (z >> 31U)) >> 32U)};
}

}  // namespace waymark::plan
