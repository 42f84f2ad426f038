// A street map: named landmarks and the ways between them, nothing else. The second domain of grounding [PPT20].
//
// A landmark is a node; a route is a list of landmarks, every step along a way. Lengths are those the map gives, in its
// own unit. People were shown a picture in which a landmark stands at (right, up): what they call north is up there,
// which need not be the north of the world.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::streets {

using LandmarkIndex = std::uint32_t;             // position in StreetMap::landmarks
using StreetRoute = std::vector<LandmarkIndex>;  // start first

struct Landmark {
  int id = 0;  // as the file has it; may have gaps
  std::string name;
  std::vector<std::string> tokens;  // words of the name
  double right = 0, up = 0;         // in the picture people saw
};

struct Way {
  LandmarkIndex to = 0;
  double length = 0;
};

struct StreetMap {
  std::string name;
  std::vector<Landmark> landmarks;
  std::vector<std::vector<Way>> ways;  // by landmark, both directions, ascending by `to`

  std::optional<LandmarkIndex> find(int id) const;
  std::optional<double> length(LandmarkIndex a, LandmarkIndex b) const;  // of the way between them
  double distance(LandmarkIndex a, LandmarkIndex b) const;               // as the crow flies, in the picture
  double mean_way() const;  // mean distance of landmarks that a way joins; 1 when there is no way
};

// Format: docs/formats/corpus-and-models.md. Throws ltl::FormatError with line and column.
StreetMap parse_street_map(std::string_view json, std::string_view source = "");
StreetMap read_street_map(const std::filesystem::path& file);

}  // namespace waymark::streets
