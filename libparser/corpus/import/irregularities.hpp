// Irregularities of a released paragraph: steps that are no action, sentences that do not join, ends that differ.
#pragma once
#include <vector>

#include "libparser/corpus/import/released.hpp"

namespace waymark::parser {

// What no reader of ours could take is mended, and reported: two poses with a U-turn between them get the pose in the
// middle (LEFT, LEFT); a pose that comes twice in a row stands once; a sentence whose trajectory is still none of the
// map is left out. All else is reported only. `map`: null when the release has no map of that name.
std::vector<Irregularity> find_irregularities(ReleasedParagraph& paragraph, const ReleasedMap* map);

}  // namespace waymark::parser
