// Features of a text against a route and its rival: what the writer can have seen, what had to be told apart, and the
// walk.
//
// The writer of a text saw two routes, the one to describe and the next longer one to the same goal, and the names of
// the landmarks on them, no others. So if a route was the one to describe, what is named stands on it or on its rival;
// a landmark of the rival alone is named because it was in the way, or is mistaken for one beside it; and the text
// should tell the two apart.
#pragma once
#include <string>
#include <vector>

#include "libparser/domain/streets/feature_list.hpp"
#include "libparser/domain/streets/street_readings.hpp"
#include "libparser/domain/streets/street_walk.hpp"

namespace waymark::streets {

struct TextOnRoute {
  const StreetMap& map;                    // of the city
  double unit;                             // mean way of the map
  const std::vector<std::string>& tokens;  // of the text
  const std::vector<Mention>& mentions;    // in the text
  const std::vector<MentionCue>& cues;     // of the mentions
  const CandidateRoute& route;             // against which the text is read
  std::vector<PlacedMention> placed;       // place(mentions, route.landmarks)
};

// How near two landmarks stand in the picture, of which each axis was stretched to fit: 0 where they coincide, 1 across
// the picture; names are written along the horizontal axis, so one above the other counts four times.
double closeness(const StreetMap& map, LandmarkIndex a, LandmarkIndex b);

// Adds the features of one kind.
void add_sight(FeatureList& out, const TextOnRoute& text);
void add_walk(FeatureList& out, const TextOnRoute& text);

}  // namespace waymark::streets
