// The observation of a pose by a network: the distances to everything that instructions name.
//
//   Objects    for each object, the fewest actions from the pose to where it stands
//   Landmarks  the same for each floor (to a place that it meets) and each painting (to a pose that looks at it) too
//   Literal    for each object, the fewest hallway segments from the place to where it stands, whatever the heading:
//     four
//              poses of a place look alike, so no policy can turn in one of them and go ahead in another
// Rows are divided by the greatest distance in the table, so that numbers are in [0, 1]; what cannot be reached is 1.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libneural/parameters.hpp"
#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

enum class Sight : std::uint8_t { Objects, Landmarks, Literal };  // what the network is told

struct Observations {
  std::vector<std::string> names;  // by row: the proposition that the distance leads to
  neural::Matrix by_position;      // [rows × poses]
};

Observations observe(const Map& map, Sight sight);  // one column for each pose

// Of any model: for each proposition that its letters carry, the fewest actions, if all goes well, to a state in which
// the proposition has just been read.
template <class Model>
Observations observe(const Model& model);

// By pose: the fewest actions to a pose whose label carries the proposition; nullopt where there is no way. O(poses).
std::vector<std::optional<std::uint32_t>> actions_to(const Map& map, ltl::Proposition p);
// By pose: the fewest hallway segments to a place where it holds facing north, as objects and floors do anyway.
std::vector<std::optional<std::uint32_t>> segments_to(const Map& map, ltl::Proposition p);

}  // namespace waymark::plan
