// Roads of a country out of an extract of OpenStreetMap: OSM XML of any size → FILE.gr, FILE.co and FILE.lab.
//
// Read twice, in a stream. First the ways tell which nodes lie on roads, then these get their positions, and roads are
// written as they come. So memory holds the points of roads and what was chosen as a landmark, not the file. What is a
// road and a landmark, and where these belong, is as in road_network.hpp (docs/formats/planning-cases.md).
#pragma once
#include <cstdint>
#include <iosfwd>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waymark::plan {

struct OsmChoice {                                        // which nodes and closed ways are landmarks
  std::vector<std::string> names;                         // by the tag `name`, in snake_case; none: all
  std::vector<std::pair<std::string, std::string>> tags;  // such as amenity=fuel; the proposition is the value
  std::stop_token stop = {};                              // ends with false when it is asked for
};

struct OsmRoads {              // what was written
  std::uint64_t nodes = 0;     // points of roads
  std::uint64_t arcs = 0;      // in one direction
  std::uint64_t missing = 0;   // points of roads that the extract lacks; streets are cut there
  std::uint64_t labelled = 0;  // nodes with a label
  std::uint64_t labels = 0;    // propositions
  bool stopped = false;        // the files are not complete
};

// Nodes are numbered by their ids, ascending; costs are centimetres. `osm` and `gr` can be sought in. Throws
// ltl::FormatError with the line: XML that is none, an id or a position that is none, a node twice, a node behind the
// ways, no road, no landmark, a landmark that is asked for and nowhere, more than 2^16 letters or 2^30 nodes.
OsmRoads write_osm_roads(std::istream& osm, std::string_view source, const OsmChoice& choice, std::ostream& gr,
                         std::ostream& co, std::ostream& lab);

}  // namespace waymark::plan
