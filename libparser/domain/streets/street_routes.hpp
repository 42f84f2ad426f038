// The k shortest simple routes of a street map between two landmarks, by Yen's algorithm [Yen71].
//
// A way is at least as short as any detour where lengths are distances, so naming all landmarks of a simple route makes
// it a plan: F(a ∧ F(b ∧ …)). Routes are therefore a complete supply of plans to choose from, and the rank of a route
// says how far out of the way it leads.
#pragma once
#include <map>
#include <utility>
#include <vector>

#include "libparser/domain/streets/street_map.hpp"

namespace waymark::streets {

struct RankedRoute {
  StreetRoute landmarks;  // from start to goal
  double length = 0;      // the sum of its ways
};

// In the order of length, then of landmarks; fewer than k when there are no more. O(k · landmarks · ways).
std::vector<RankedRoute> shortest_simple_routes(const StreetMap& map, LandmarkIndex start, LandmarkIndex goal,
                                                std::size_t k);

// A least-length route that steps on no landmark of `avoided` (its ends excepted); empty when there is none.
StreetRoute shortest_street_route(const StreetMap& map, LandmarkIndex start, LandmarkIndex goal,
                                  const std::vector<bool>& avoided);

// How far a landmark stands from the nearest leg of a route, in the picture. Infinite for a route without legs.
double distance_from(const StreetMap& map, const StreetRoute& route, LandmarkIndex landmark);

// The ranked routes of one map, computed when they are first asked for and kept.
class RouteTable {
 public:
  RouteTable(const StreetMap& map, std::size_t k) : map_(&map), k_(k) {}  // the map must outlive it
  // The shortest first; computed when first asked for.
  const std::vector<RankedRoute>& routes(LandmarkIndex start, LandmarkIndex goal);

 private:
  const StreetMap* map_;
  std::size_t k_;
  std::map<std::pair<LandmarkIndex, LandmarkIndex>, std::vector<RankedRoute>> routes_;
};

}  // namespace waymark::streets
