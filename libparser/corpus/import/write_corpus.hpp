// Released paragraphs and maps as JSON of ours.
#pragma once
#include <string>
#include <vector>

#include "libparser/corpus/import/released.hpp"

namespace waymark::parser {

// One line, without its end. Open headings get the two readings of docs/conventions.md 8: path_north, path_right90.
std::string json_line(const ReleasedParagraph& paragraph, const std::vector<Irregularity>& flags);
std::string json_map(const ReleasedMap& map);

}  // namespace waymark::parser
