// Which words of a command name which landmark of a city: by names, parts and misspellings of names, and by tags.
#pragma once
#include <string>
#include <vector>

#include "libparser/domain/commands/city_words.hpp"
#include "libparser/lifted/mention_weights.hpp"
#include "libparser/mention/mention.hpp"

namespace waymark::parser {

struct LandmarkLift {              // a text whose mentions of landmarks are slots
  LiftedText text;                 // its mentions are slots
  std::vector<std::size_t> slots;  // landmarks of slot 1, 2 …
  double probability = 1;          // that the words name just these
};

// The readings of the mentions, likeliest first; one at least. Covers that name the same landmarks in the same order,
// and negate the same ones, are one reading.
std::vector<LandmarkLift> lift_landmarks(const std::string& text, const CityWords& city, const MentionModel& model);

// The tokens of a text in which landmarks are looked for: "-", "_" and "/" separate words.
std::vector<std::string> landmark_tokens(const std::string& text);

}  // namespace waymark::parser
