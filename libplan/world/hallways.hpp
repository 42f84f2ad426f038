// Hallways: the plan of a building as a graph on integer coordinates. This header has the geometry only;
// world/labelling.hpp has the observations, world/map.hpp the letters and actions.
//
// y grows downwards (south); headings in degrees clockwise: 0 is y − 1, 90 is x + 1, 180 is y + 1, 270 is x − 1. A
// segment joins two orthogonal neighbours; without a segment there is a wall. The environments of [MSK06] have this
// form.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace waymark::plan {

struct Pose {                     // where one stands, and where one looks
  int x = 0, y = 0, heading = 0;  // heading ∈ {0, 90, 180, 270}
  friend auto operator<=>(const Pose&, const Pose&) = default;
};
std::string show(const Pose& pose);  // "(1,9,270)"

struct Node {                         // a place
  int x = 0, y = 0;                   // of the place
  std::optional<std::string> object;  // furniture standing here
  std::optional<int> place;           // numbered position
};

struct Edge {                  // undirected, between orthogonal neighbours at distance 1
  std::uint32_t a = 0, b = 0;  // node indices
  std::string floor, wall;     // pattern of the floor, painting on the wall; empty: none
};

class Hallways {
 public:
  static constexpr int max_coordinate = 1'000'000;  // |x|, |y|
  static constexpr int max_place = 1'000;           // places are numbered 1 … max_place

  // Both throw std::invalid_argument naming the fault: a place taken twice, a coordinate or place number out of
  // bounds; an edge that does not join orthogonal neighbours, names a node that is not there, or comes twice.
  void add_node(Node node);
  void add_edge(Edge edge);

  // In the order of the file.
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Edge>& edges() const { return edges_; }
  std::optional<std::uint32_t> node_at(int x, int y) const;  // O(log nodes)
  // The segment that leaves the node in that heading; nullptr: a wall.
  const Edge* hallway(std::uint32_t node, int heading) const;
  std::optional<std::uint32_t> neighbour(std::uint32_t node, int heading) const;

 private:
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::map<std::pair<int, int>, std::uint32_t> index_;  // (x, y) → node
  std::vector<std::array<std::int32_t, 4>> ways_;       // edge by node and heading / 90, −1: a wall
};

}  // namespace waymark::plan
