// Routes: what a plan comes down to on the map, a trajectory and its cost.
#pragma once
#include <cstddef>
#include <string>

#include "libplan/solve/outcome.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::plan {

struct Route : Trajectory {  // poses, actions
  double cost = 0;           // sum over the actions
};

// Sums the costs of the actions, first to last.
Route priced(Trajectory trajectory, const Map& map);

// The route that the policy takes from its start until it says stop. Throws std::logic_error when the policy leads
// into a wall or round in a circle.
Route roll_out(const MapProduct& product, const Policy& policy);

// Why there is none: no word at all, or none from here, where so many pairs of pose and state were looked at.
std::string no_run(const automata::Dfa& dfa, std::size_t pairs);

}  // namespace waymark::plan
