// The maps of this domain: what people were shown of a city (libplan/world/street_map.hpp), ways in a fixed order.
#pragma once
#include <filesystem>
#include <string_view>

#include "libplan/world/street_map.hpp"

namespace waymark::streets {

using plan::Landmark;
using plan::LandmarkIndex;
using plan::StreetMap;
using plan::StreetRoute;
using plan::Way;

// Ways ascending by `to`, so that ties between routes do not depend on the order of the file.
// Throws ltl::FormatError with line and column.
StreetMap parse_street_map(std::string_view json, std::string_view source = "");
StreetMap read_street_map(const std::filesystem::path& file);

}  // namespace waymark::streets
