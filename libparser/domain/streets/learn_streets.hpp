// Learning to choose among the routes of a text, from routes alone: AdaGrad [DHS11] on the likelihood of the right one.
//
// Every other candidate is a wrong answer. One is known to be wrong for the writer too: the picture showed the next longer route
// to the same goal as the one not to describe (`alt_path` of the corpus, which is that route in every line). It is pushed
// away once more:
//
//   loss = −log p(gold) + against_rival · log(1 + exp(1 + score(rival) − score(gold)))
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>

#include "libparser/domain/streets/street_model.hpp"

namespace waymark::streets {

struct StreetOptions {
  std::uint64_t seed = 1;  // the order of the texts
  int epochs = 8;
  double rate = 0.05, decay = 4e-2;  // AdaGrad's step and L2, for every update
  double against_rival = 0.5;        // 0: the rival is a candidate like any other
  // For cities whose texts are all there, unread: naming habits (naming_habits.hpp) and a second look (second_look.hpp). Costs
  // a training more for each city.
  bool adapt = false;
  CandidateLimits limits;
  std::stop_token stop;
};

// Nobody's answer when stop was requested: returns std::nullopt.
std::optional<StreetModel> learn_streets(std::span<const StreetInstruction* const> instructions,
                                         const std::vector<StreetMap>& maps, const StreetOptions& options);

}  // namespace waymark::streets
