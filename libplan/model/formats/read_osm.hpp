// Extracts of OpenStreetMap in XML (FILE.osm), as models: https://wiki.openstreetmap.org/wiki/OSM_XML.
//
// Roads are the ways with the tag `highway`; `oneway` and roundabouts are respected. Landmarks are nodes with a name,
// areas are closed ways with a name that are no roads. Relations are not read.
#pragma once
#include <string_view>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// States are called by the ids of nodes; docs/formats/planning-cases.md. At most 1 GiB. Throws ltl::FormatError.
Mdp parse_osm(std::string_view xml, std::string_view source = "", std::string_view start = "");

}  // namespace waymark::plan
