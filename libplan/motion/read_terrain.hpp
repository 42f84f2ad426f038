// Terrains from JSON (docs/formats/terrains.md): boundary, obstacles, named regions.
#pragma once
#include <string_view>

#include "libplan/motion/terrain.hpp"

namespace waymark::plan {

// Throws ltl::FormatError with line and column, naming the value: "regions[1].polygon[0]: expected a point [x,y]".
Terrain parse_terrain(std::string_view json, std::string_view source = "");

}  // namespace waymark::plan
