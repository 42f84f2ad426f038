// What the texts of a city show of its naming habits before any of them is read: how often each landmark is named, against how
// often the routes that people are shown pass it.
//
// Pictures are made in a known way (route_prior.hpp), so how many texts should pass a landmark, or go straight from one to the
// next, follows from the map and the starts alone. A landmark that is named half as often as that is left out, or taken for its
// neighbour, half of the time; one that is named more often is named for others, or where it stands beside the way.
#pragma once
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "libparser/domain/streets/street_routes.hpp"

namespace waymark::streets {

struct UnreadText {
  LandmarkIndex start = 0;
  std::vector<LandmarkIndex> named;  // best fits of its mentions, in their order
};

using WayEnds = std::pair<LandmarkIndex, LandmarkIndex>;  // the smaller first

struct NamingHabits {
  // By landmark: texts that name it, but not as their start, over texts whose route should pass it.
  std::vector<double> named;
  // By way: texts that name its ends one right after the other, over texts whose route should take it.
  std::map<WayEnds, double> said;
  double usual_named = 1, usual_said = 1;  // the same over all landmarks, all ways

  bool known() const { return !named.empty(); }
};

// Shares are drawn towards the usual one, as if ten texts more had it. O(texts · words + landmarks² · ranks).
NamingHabits naming_habits(const StreetMap& map, RouteTable& routes, std::span<const UnreadText> texts);

}  // namespace waymark::streets
