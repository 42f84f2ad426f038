// Maps from JSON files (docs/formats/maps-and-routes.md), and from the maps that come with waymark.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/world/map.hpp"

namespace waymark::plan {

// Throws ltl::FormatError with line and column, naming the value: "nodes[3].x: expected a whole number".
Map parse_map(std::string_view json, std::string_view source = "");

// `name_or_file`: a file, or the name of a shipped map (grid, jelly, l) found in `data`/maps. Throws ltl::FormatError;
// an unknown name lists the known ones.
Map read_map(const std::string& name_or_file, const std::filesystem::path& data);

// The names of the maps in `data`/maps, sorted; empty when there is no such directory.
std::vector<std::string> shipped_maps(const std::filesystem::path& data);

}  // namespace waymark::plan
