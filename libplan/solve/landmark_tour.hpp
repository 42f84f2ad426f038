// Tours of landmarks: the shortest closed walk through all of them, and the shortest walk that visits all, by landmark
// compression. A landmark is a proposition; it is visited where a letter carries it.
//
// Least costs between the places that carry a landmark, one search on the model from each, then dynamic programming
// over (landmarks visited, last place) [HK62]. Exact: whatever a least-cost walk passes on its way is a landmark place
// too and a step of its own. O(places · model + 2^landmarks · places²) instead of 2^landmarks · model.
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/solve/dijkstra.hpp"

namespace waymark::plan {

struct LandmarkTour {
  double cost = 0;                   // of the whole walk
  std::vector<std::uint32_t> stops;  // places, in order; of a closed walk the last is the first again
};
struct NoLandmarkTour {  // proved
  std::string reason;    // which landmark cannot be visited
};
constexpr std::size_t most_landmarks = 20;  // of one tour

// Closed: through all landmarks and back, anywhere within reach of the start; the way to it costs nothing. Open: from
// the start, whose own letter counts, until all have been visited. nullopt: stopped. Throws std::invalid_argument for a
// model that is not deterministic, for more than most_landmarks, and for a landmark whose place shows it on one way in
// but not on another.
template <class Model>
std::optional<std::variant<LandmarkTour, NoLandmarkTour>> shortest_tour(const Model& model,
                                                                        const std::vector<std::string>& landmarks,
                                                                        bool closed, const std::stop_token& stop = {});

// The walk itself, a least-cost walk from each stop to the next. O(stops · model log model). Throws std::logic_error
// for stops between which there is no way.
template <class Model>
ChoiceRoute walk(const Model& model, const LandmarkTour& tour);

}  // namespace waymark::plan
