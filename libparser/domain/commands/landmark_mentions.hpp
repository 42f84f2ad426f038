// Which words of a command name which landmark of a city: by names, parts and misspellings of names, and by tags.
//
// A phrase is worth what its words tell: a word that fits few landmarks of the map tells more (inverse frequency).
// The best set of phrases that do not overlap is found by dynamic programming over the tokens.
#pragma once
#include <string>
#include <vector>

#include "libparser/domain/commands/landmark.hpp"
#include "libparser/mention/mention.hpp"

namespace waymark::parser {

struct LandmarkLift {
  LiftedText text;
  std::vector<std::size_t> slots;  // landmarks of slot 1, 2 …
  double probability = 1;          // that the words name just these
};

// The readings of the mentions, likeliest first; one at least.
std::vector<LandmarkLift> lift_landmarks(const std::string& text, const std::vector<Landmark>& landmarks);

}  // namespace waymark::parser
