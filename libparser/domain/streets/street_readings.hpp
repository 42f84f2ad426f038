// The ways in which the landmarks of a text can be strung together: typed candidates F(a ∧ F(b ∧ …)) before any map.
//
// Read as they stand, mentions are the route in order. Words between them may say otherwise: "to c via b", "to c from
// a", "to c after b" put a later mention first; "past b", "not b" may name what is only passed by, or not met at all; a
// text may open with the neighbour of the landmark where it starts. Each of these can be followed or not: a reading is
// the sequence that comes out, with what was followed to get it.
#pragma once
#include <string_view>
#include <vector>

#include "libparser/domain/streets/street_candidates.hpp"

namespace waymark::streets {

enum class Cue : std::uint8_t { None, Via, Past, Not, Before, After, First, From, To, End, Back };
Cue cue_of(std::string_view word);  // None for other words

// How a mention is brought in: by the last cue before it; "via a and b", "past a, b" hand theirs on.
struct MentionCue {
  Cue cue = Cue::None;   // before the mention
  bool onwards = false;  // something is reached right after it, in the same sentence
};
// By mention.
std::vector<MentionCue> mention_cues(const std::vector<std::string>& tokens, const std::vector<Mention>& mentions);

struct Interpretation {  // the mentions as a route
  // What was done to the order of the mentions.
  static constexpr unsigned reordered = 1, passed_by = 2, another_start = 4;
  unsigned followed = 0;  // of the three
  StreetRoute landmarks;  // start first, none twice
};

// Distinct, the plainest first; at most eight.
std::vector<Interpretation> readings(LandmarkIndex start, const std::vector<PlacedMention>& mentions,
                                     const std::vector<MentionCue>& cues);

}  // namespace waymark::streets
