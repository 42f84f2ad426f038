// What is odd about a released paragraph: steps that are no action, sentences that do not join, ends that differ.
#pragma once
#include <vector>

#include "libparser/import/released.hpp"

namespace waymark::parser {

// Two poses with a U-turn between them get the pose in the middle (LEFT, LEFT), everywhere; reported.
// All others are reported only. `map`: null when the release has no map of that name.
std::vector<Irregularity> find_irregularities(ReleasedParagraph& paragraph, const ReleasedMap* map);

}  // namespace waymark::parser
