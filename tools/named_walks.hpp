// Walks on a model that are told by the names of their places and actions.
//
// Several choices of a state may have one name and lead to one place, such as two roads between two crossings: a
// telling then stands for several walks, which differ in cost and letters.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/word.hpp"
#include "libplan/model/model.hpp"

namespace waymark::tools {

struct ToldWalk {
  std::uint32_t end = 0;
  double cost = 0;
  std::vector<ltl::Letter> letters = {};  // of the steps
  std::size_t ways = 1;                   // walks that differ in none of these
};

constexpr std::size_t most_told_walks = 10'000;

// All of them, none where the model has no such walk. Nothing: more than most_told_walks.
template <class Model>
std::optional<std::vector<ToldWalk>> told_walks(const Model& model, std::uint32_t from,
                                                const std::vector<std::string>& places,
                                                const std::vector<std::string>& actions) {
  if (places.size() != actions.size() + 1 || model.name(from) != places[0]) return std::vector<ToldWalk>{};
  std::vector<ToldWalk> walks{{from}};
  for (std::size_t i = 0; i < actions.size(); ++i) {
    std::vector<ToldWalk> longer;
    for (const ToldWalk& walk : walks)
      for (std::uint32_t k = 0; k < model.choices(walk.end); ++k) {
        if (model.action(walk.end, k) != actions[i] || model.outcome_count(walk.end, k) != 1) continue;
        const plan::ModelOutcome outcome = model.outcome(walk.end, k, 0);
        if (model.name(outcome.target) != places[i + 1]) continue;
        ToldWalk next{outcome.target, walk.cost + model.cost(walk.end, k), walk.letters, walk.ways};
        next.letters.push_back(model.letters()[outcome.letter]);
        const auto twin = std::find_if(longer.begin(), longer.end(), [&](const ToldWalk& other) {
          return other.end == next.end && other.cost == next.cost && other.letters == next.letters;
        });
        if (twin != longer.end())
          twin->ways += next.ways;
        else
          longer.push_back(std::move(next));
        if (longer.size() > most_told_walks) return std::nullopt;
      }
    walks = std::move(longer);
  }
  return walks;
}

}  // namespace waymark::tools
