// Learning to choose among the routes of a text, from routes alone: AdaGrad [DHS11] on the likelihood of the right one.
//
// Every other candidate is a wrong answer, the one that writers were told not to describe among them: it is the next
// longer route to the same goal.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>

#include "libparser/streets/street_model.hpp"

namespace waymark::streets {

struct StreetOptions {
  std::uint64_t seed = 1;  // the order of the texts
  int epochs = 8;
  double rate = 0.05, decay = 1e-2;  // AdaGrad's step and L2, for every update
  CandidateLimits limits;
  std::stop_token stop;
};

// Nobody's answer when stop was requested: returns std::nullopt.
std::optional<StreetModel> learn_streets(std::span<const StreetInstruction* const> instructions,
                                         const std::vector<StreetMap>& maps, const StreetOptions& options);

}  // namespace waymark::streets
