// Passes over chunks, for tests of those who run them.
#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "libplan/solve/pipelined_passes.hpp"

namespace waymark::plan::testing {

// Passes behind a front that moves on where chunks have settled, then over all of them; what they were, in words.
struct Fronts {
  std::size_t chunks;
  std::size_t reached = 1;
  std::size_t passes = 0;
  std::string told = {};

  Pass first() { return {0, std::min(reached, chunks)}; }
  std::optional<Pass> operator()(const Pass& pass, std::size_t unsettled) {
    told += std::to_string(pass.begin) + '-' + std::to_string(pass.end) + ':' + std::to_string(unsettled) + ' ';
    const bool whole = pass.begin == 0 && pass.end == chunks;
    if (++passes == 300 || (whole && unsettled == pass.end)) return std::nullopt;
    reached += 2;
    if (unsettled == chunks || whole) return Pass{0, chunks};
    return Pass{unsettled, std::clamp(reached, unsettled + 1, chunks)};
  }
};

}  // namespace waymark::plan::testing
