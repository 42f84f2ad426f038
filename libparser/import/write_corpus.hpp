// Released paragraphs and maps as JSON of ours.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "libparser/import/released.hpp"

namespace waymark::parser {

// One line, without its end. Open headings get the two readings of docs/conventions.md 8: path_north, path_right90.
std::string json_line(const ReleasedParagraph& paragraph, const std::vector<Irregularity>& flags);
// The flags of lines that are ours already, each with its line.
std::vector<Irregularity> flags_of(std::string_view json_lines, const std::string& file);
std::string json_map(const ReleasedMap& map);

}  // namespace waymark::parser
