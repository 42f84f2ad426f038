// Maps for the tests of this area: the shipped three, and small ones whose routes can be enumerated by hand.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "libplan/world/map.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::plan {

inline std::filesystem::path data_directory() { return std::filesystem::path(WAYMARK_SOURCE_DIR) / "data"; }
inline Map shipped(const std::string& name) { return read_map(name, data_directory()); }

inline PoseId pose_at(const Map& map, int x, int y, int heading) {
  const auto id = map.find({x, y, heading});
  if (!id) throw std::logic_error("the test names a pose that is not on the map");
  return *id;
}

// A hallway of `length` segments running east from (0,0); a chair at its end, blue floor on the first segment,
// brick on the others.
inline Map hallway(int length) {
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  for (int x = 0; x <= length; ++x) nodes.push_back({x, 0, std::nullopt, std::nullopt});
  nodes.back().object = "chair";
  for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(length); ++x)
    edges.push_back({x, x + 1, x == 0 ? "blue" : "brick", "fish"});
  return Map("hallway", nodes, edges, {"chair", "sofa"}, {"blue", "brick"}, {"fish"});
}

// A square of four corners, (0,0) to (1,1), with a sofa at (1,1) and place 1 at (0,0): two ways round to everything.
inline Map square() {
  const std::vector<Node> nodes{{0, 0, std::nullopt, 1},
                                {1, 0, std::nullopt, std::nullopt},
                                {1, 1, "sofa", std::nullopt},
                                {0, 1, std::nullopt, std::nullopt}};
  const std::vector<Edge> edges{{0, 1, "blue", ""}, {1, 2, "brick", ""}, {2, 3, "blue", ""}, {3, 0, "brick", ""}};
  return Map("square", nodes, edges, {"chair", "sofa"}, {"blue", "brick"}, {"fish"});
}

// A plus of four arms of one segment round (1,1), without a floor on the southern arm and a chair on the western end.
inline Map plus() {
  const std::vector<Node> nodes{{1, 1, std::nullopt, std::nullopt},
                                {1, 0, std::nullopt, 1},
                                {2, 1, "sofa", std::nullopt},
                                {1, 2, std::nullopt, std::nullopt},
                                {0, 1, "chair", std::nullopt}};
  const std::vector<Edge> edges{{0, 1, "blue", "fish"}, {0, 2, "brick", ""}, {0, 3, "", ""}, {4, 0, "blue", ""}};
  return Map("plus", nodes, edges, {"chair", "sofa"}, {"blue", "brick"}, {"fish"});
}

}  // namespace waymark::plan
