// Our own JSON Lines as a release, so that what is odd about them is found in the same way.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "libparser/corpus/import/released.hpp"
#include "libplan/world/map.hpp"

namespace waymark::parser {

struct FlaggedParagraph {
  ReleasedParagraph paragraph;      // of the line
  std::optional<int> start_place;   // of its first sentence
  std::vector<Irregularity> flags;  // that the line itself names
};
// Lines that parse_sail_corpus has read. Throws ltl::FormatError where start_place, goal, path, num or flags have
// another shape.
std::vector<FlaggedParagraph> parse_lines(std::string_view json_lines, std::string_view file);

ReleasedMap released(const plan::Map& map);  // the map as a release has it

}  // namespace waymark::parser
