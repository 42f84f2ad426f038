// The walk of a text along a route: a monotone alignment of mentions with the landmarks of the route.
//
// People name what they pass twice, turn back past where they have been, and warn of what must not be entered; a simple
// route stands on each of its landmarks once. So each mention is either a step of the walk (it stays where the walk is,
// or goes on to a landmark further along) or no step, and then it says something else: ahead of where the walk is,
// behind it, back at the start, on the rival route, or nowhere near. The walk is the one that leaves least unsaid:
//
//   cost = landmarks of the route that no step reaches + 0.4 · mentions that are no step
#pragma once
#include <cstdint>
#include <vector>

#include "libparser/domain/streets/street_candidates.hpp"

namespace waymark::streets {

enum class MentionRole : std::uint8_t { Stays, GoesOn, Ahead, Behind, AtStart, OnRival, Unseen };
// Of a walk that does not reach the goal; of a mention that is no step.
constexpr double cost_unreached = 1, cost_no_step = 0.4;

struct Walk {                      // an alignment
  std::vector<MentionRole> steps;  // by mention
  std::size_t unreached = 0;       // landmarks of the route that no mention steps on; the start counts as reached
  bool reaches_goal = false;       // by its last step
  double cost = 0;                 // of the alignment
};

// Of several walks of least cost, the one that goes on where it can late. O(mentions · landmarks²), nothing else.
Walk walk_along(const CandidateRoute& route, const std::vector<PlacedMention>& mentions);

bool stands_on(const StreetRoute& route, LandmarkIndex landmark);  // is the landmark on the route?

}  // namespace waymark::streets
