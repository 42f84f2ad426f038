// The features of a text against a route, for the reranker: the text has no names any more.
//
// From mention to mention, how the route moves on (one landmark further, back, nowhere, off the route) goes with the
// words between; landmarks that the route passes and nobody names go with how far out of the way they are; landmarks
// that are named and not passed with how near the route comes; directions with the angle of the leg in the picture.
// Nothing is about a city: distances are in units of its mean way.
#pragma once
#include <vector>

#include "libparser/domain/streets/feature_list.hpp"
#include "libparser/domain/streets/street_readings.hpp"

namespace waymark::streets {

RouteFeatures street_features(const StreetMap& map, double unit, const std::vector<std::string>& tokens,
                              const std::vector<Mention>& mentions, const std::vector<MentionCue>& cues,
                              const CandidateRoute& route);

}  // namespace waymark::streets
