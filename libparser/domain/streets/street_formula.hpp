// A route over landmarks as a formula whose plan it is: F(a ∧ F(b ∧ …)) with as few landmarks as it takes.
//
// The plan of F(a ∧ F(b ∧ …)) goes the shortest way to a, from there to b, and so on. A landmark is named where the
// shortest way from the last one named leaves the route; naming them all is always enough when a way is the shortest
// connection of its ends, as it is where lengths are distances.
#pragma once
#include <optional>

#include "libltl/formula.hpp"
#include "libparser/domain/streets/street_map.hpp"

namespace waymark::streets {

// The landmarks to name, the goal last; none when a way of the route is longer than a detour.
std::optional<StreetRoute> waypoints(const StreetMap& map, const StreetRoute& route);

// Propositions are called as in street graphs that are planned on (plan::landmark_name): "Blue Room", blue_room.
ltl::Formula visit_in_order(const StreetMap& map, const StreetRoute& landmarks, ltl::Arena& arena);

}  // namespace waymark::streets
