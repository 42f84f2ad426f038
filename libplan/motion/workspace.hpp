// The workspace: the hallways of a map as free space in the plane.
//
// Coordinates are those of the map: one unit is the distance of neighbouring places, y grows southwards. A node is a
// square cell as wide as the hallways, an edge the rectangle between two of those squares, furniture a round obstacle
// in the middle of its cell. Everything else is wall. The route of a motion follows from these cells (motion.hpp). A
// map has no metres. With 3 m between places, the default hallways are 1.2 m wide, furniture is 42 cm across, and a
// robot of radius 0.05 is 30 cm across.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/motion/free_space.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

struct WorkspaceShape {     // sizes
  double width = 0.4;       // of hallways, 0 < width < 1
  double furniture = 0.07;  // radius of every piece, 0 ≤ furniture < width / 2; 0: none
};

struct Cell {                                     // of the free space
  enum class Kind : std::uint8_t { Node, Edge };  // what a cell stands for
  Kind kind = Kind::Node;                         // of the cell
  std::uint32_t index = 0;                        // of the node or edge in the map
  friend bool operator==(const Cell&, const Cell&) = default;
};

class Workspace : public FreeSpace {
 public:
  // The map must outlive the workspace. Throws std::invalid_argument on a shape out of bounds.
  explicit Workspace(const Map& map, const WorkspaceShape& shape = {});
  const Map& map() const { return *map_; }
  double width() const { return shape_.width; }
  double furniture() const { return shape_.furniture; }

  Point centre(std::uint32_t node) const;  // of a place
  // The cell that p lies in; on the border of two, the node's. nullopt: a wall. Furniture stands in its cell.
  // O(log nodes).
  std::optional<Cell> cell_at(Point p) const;

  bool admits(Point p, double radius) const { return admits(p, p, radius); }  // may a disc of that radius stand there?
  bool admits(Point a, Point b, double radius) const override;                // O(distance of a and b · log nodes)
  bool contains(Point p) const override { return cell_at(p).has_value(); }
  double clearance(const Box& box, double most) const override;  // O(1), most < 1

  // Where a disc can stand in the cell of a node: its centre, or a few points around the furniture there. Empty: no
  // such point is known.
  std::vector<Point> stands(std::uint32_t node, double radius) const;

 private:
  struct Wall {
    Point a, b;
  };
  std::vector<Wall> walls_around(std::uint32_t node) const;
  bool is_furnished(std::uint32_t node) const;
  bool keeps_off(std::uint32_t node, Point a, Point b, double radius) const;

  const Map* map_;
  WorkspaceShape shape_;
  std::vector<std::vector<Wall>> walls_;  // by node: of its square, and along the edges that meet it
};

}  // namespace waymark::plan
