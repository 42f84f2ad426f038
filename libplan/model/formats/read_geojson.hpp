// GeoJSON files (FILE.geojson) as models: RFC 7946.
//
// Lines are roads; lines that share a position cross there. Points and polygons with a property `name` are landmarks
// and areas.
#pragma once
#include <string_view>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// States are called by their positions, "-71.40,41.82"; docs/formats/planning-cases.md. Throws ltl::FormatError with
// line and column.
Mdp parse_geojson(std::string_view json, std::string_view source = "", std::string_view start = "");

}  // namespace waymark::plan
