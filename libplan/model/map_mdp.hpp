// Hallway maps as Markov decision processes: the model that all solvers share.
#pragma once
#include <cstdint>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

// State p is the pose with that PoseId, choices are the actions that are possible there in the order FORWARD, LEFT,
// RIGHT, letters are the map's with the events of the action. Turns never slip; FORWARD slips into the hallway on the
// left, on the right or behind, heading kept, and stays where there is none (the event `moved` is read all the same).
Mdp mdp_of(const Map& map, PoseId start, const SlipChances& forward = {});

}  // namespace waymark::plan
