// Learning to choose among the routes of a text, from routes alone, by the ranker.
//
// Every other candidate is a wrong answer. One is known to be wrong for the writer too: the picture showed the next longer route
// to the same goal as the one not to describe (`alt_path` of the corpus, which is that route in every line). It is the rival.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "libparser/domain/streets/street_model.hpp"
#include "libparser/training/learn_ranker.hpp"

namespace waymark::streets {

struct StreetOptions {
  parser::RankerOptions ranker{.epochs = 8,
                               .rate = 0.05,
                               .decay = 4e-2,
                               .first_squares = std::numeric_limits<float>::min(),
                               .least_error = 1e-5,
                               .against_rival = 0.5,
                               .least_maps = 3};
  CandidateLimits limits;
};

// Throws Stopped (supervision/examples.hpp) when a stop was requested.
StreetModel learn_streets(std::span<const StreetInstruction* const> instructions,
                          const std::vector<StreetMap>& maps, const StreetOptions& options);

}  // namespace waymark::streets
