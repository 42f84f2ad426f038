// Roads and named landmarks, read from extracts of maps of the world and from graphs (docs/formats/planning-cases.md).
//
// A node is a point of a road; its letter has the names of the landmarks there, in snake_case. Costs are metres. What
// readers collect on the globe becomes such a network once: a landmark beside the roads belongs to the nearest node,
// an area to every node inside it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

inline constexpr std::size_t most_road_bytes = std::size_t{1} << 30U;  // of a file

struct RoadNetwork {       // points of roads, and what stands there
  struct Road {            // a piece of road, in one direction
    std::uint32_t to = 0;  // index in nodes
    double cost = 0;       // metres where positions are known
  };
  struct Node {                          // a point of a road
    std::string name;                    // of the state: an id of the file, or a position
    std::vector<std::string> landmarks;  // propositions
    std::vector<Road> roads;             // that leave here
  };
  std::vector<Node> nodes;  // in the order of the file
};

// A state is a node, a choice a road, called after the node it leads to; nothing slips. Runs begin at `start`, a
// node's name or a landmark; empty: at the first node with a landmark. O(nodes + roads). Throws ltl::FormatError: no
// node, no landmark, no such start.
Mdp model_of(const RoadNetwork& network, std::string_view source, std::string_view start);

struct GlobePoint {      // WGS 84, in degrees
  double longitude = 0;  // within ±180, eastwards
  double latitude = 0;   // within ±90, northwards
};

// What a reader collects, in any order.
class GlobeRoads {
 public:
  enum class Direction : std::uint8_t { Both, Forward, Backward };  // of traffic between the ends of a road
  static constexpr std::uint32_t no_point = UINT32_MAX;             // before the first of a road
  using Ring = std::vector<GlobePoint>;                             // closed or not

  // The source is named in errors. At most 10,000,000 points.
  explicit GlobeRoads(std::string_view source) : source_(source) {}

  // A point of a road. Points of equal `name` are one; a road that reuses one crosses there.
  std::uint32_t add_point(const GlobePoint& at, const std::string& name);
  void add_road(std::uint32_t a, std::uint32_t b, Direction direction);
  void add_landmark(const GlobePoint& at, std::string_view name);        // nothing for a name without a letter
  void add_area(const std::vector<Ring>& rings, std::string_view name);  // the outer ring first, then holes

  // Every landmark at its node. O((points + landmarks) log points), and for an area the points in its bounding box.
  // Throws ltl::FormatError when there is no road.
  RoadNetwork build() &&;

 private:
  struct Landmark {
    GlobePoint at;
    std::string name;
  };
  struct Area {
    std::vector<Ring> rings;
    std::string name;
  };
  void place_landmarks();
  void place_areas();

  std::string source_;
  RoadNetwork network_;
  std::vector<GlobePoint> points_;  // of the nodes
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<Landmark> landmarks_;
  std::vector<Area> areas_;
};

}  // namespace waymark::plan
