// Hallway maps as Markov decision processes: the model that all solvers share.
#pragma once
#include <cstdint>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

struct TurnChances {  // what a turn may do instead; the rest is as meant
  double stay = 0;    // comes to nothing
  double beyond = 0;  // goes on to the opposite heading
  friend bool operator==(const TurnChances&, const TurnChances&) = default;
};
struct MapNoise {
  MapNoise(
      const SlipChances& of_forward = {},  // NOLINT(google-explicit-constructor): most noise is that alone
      const TurnChances& of_turns = {})
      : forward(of_forward), turn(of_turns) {}
  SlipChances forward;
  TurnChances turn;
  friend bool operator==(const MapNoise&, const MapNoise&) = default;
};

// State p is the pose with that PoseId, choices are the actions that are possible there in the order FORWARD, LEFT,
// RIGHT, letters are the map's with the events of the action. FORWARD slips into the hallway on the left, on the right or
// behind, heading kept, and stays where there is none. Whatever comes of an action, its event is read. Throws
// std::invalid_argument for chances of a turn that are negative or leave nothing for turning.
Mdp mdp_of(const Map& map, PoseId start, const MapNoise& noise = {});

}  // namespace waymark::plan
