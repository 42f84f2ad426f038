// A street map: named landmarks and the ways between them, nothing else [PPT20]. Planned on
// (model/formats/read_streets.hpp) and instructed about (libparser/domain/streets).
//
// A landmark is a node; a route is a list of landmarks, every step along a way. Lengths are those the map gives, in its
// own unit. People were shown a picture in which a landmark stands at (right, up): what they call north is up there,
// which need not be the north of the world.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::plan {

using LandmarkIndex = std::uint32_t;             // position in StreetMap::landmarks
using StreetRoute = std::vector<LandmarkIndex>;  // start first

struct Landmark {            // a place with a name
  int id = 0;                // as the file has it; may have gaps
  std::string name;          // may occur twice
  double right = 0, up = 0;  // in the picture people saw; 0 when it is not read
};

struct Way {             // to a neighbour
  LandmarkIndex to = 0;  // the neighbour
  double length = 0;     // as the file has it
};

struct StreetMap {
  std::string name;                    // of the city
  std::vector<Landmark> landmarks;     // in the order of the file
  std::vector<std::vector<Way>> ways;  // by landmark, both directions, in the order of the file

  std::optional<LandmarkIndex> find(int id) const;  // by the number in the file
  std::optional<double> length(LandmarkIndex a,
                               LandmarkIndex b) const;      // of the way between them; O(ways of a)
  double distance(LandmarkIndex a, LandmarkIndex b) const;  // as the crow flies, in the picture
  double mean_way() const;  // mean distance of landmarks that a way joins; 1 when there is no way
};

// What is read beside landmarks and ways.
enum class StreetView : std::uint8_t {
  Ground,  // lengths in metres; landmarks differ in landmark_name
  // What people were shown: the map's name, positions in the picture and lengths there; those on the ground where
  // absent.
  Picture
};

// Format: docs/formats/corpus-and-models.md. Throws ltl::FormatError with line and column.
StreetMap parse_street_map(std::string_view json, StreetView view, std::string_view source = "");

// What a landmark's proposition is called, "Blue Room" → "blue_room": letters and digits in lower case, apostrophes
// left out, anything else an underscore.
std::string landmark_name(std::string_view name);

}  // namespace waymark::plan
