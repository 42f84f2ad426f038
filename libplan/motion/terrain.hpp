// A terrain: a workspace of polygons, with a border, obstacles, and regions with names.
//
// The free space is the inside of the border minus the obstacles. The letter of a point is the set of the regions that
// contain the point. Regions may overlap and share a name. Coordinates are those of the polygons, y southwards;
// headings are degrees clockwise from north.
#pragma once
#include <string>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/motion/free_space.hpp"

namespace waymark::plan {

struct NamedRegion {  // a part of the plane
  std::string name;   // the proposition
  Polygon border;     // of the region
};

class Terrain : public FreeSpace {
 public:
  // Throws std::invalid_argument naming the polygon that has fewer than three corners, meets itself, or has no area.
  Terrain(std::string name, Polygon border, std::vector<Polygon> obstacles, std::vector<NamedRegion> regions);

  // As the file has them.
  const std::string& name() const { return name_; }
  const Polygon& border() const { return border_; }
  const std::vector<Polygon>& obstacles() const { return obstacles_; }
  const std::vector<NamedRegion>& regions() const { return regions_; }
  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }  // the names of the regions
  Point low() const { return low_; }                                 // opposite corners of the least rectangle
  Point high() const { return high_; }                               // the other corner

  struct Edge {  // of a polygon
    Point a, b;  // its ends
  };
  const std::vector<Edge>& walls() const { return walls_; }              // of the border and the obstacles
  const std::vector<Edge>& region_edges() const { return edges_; }       // where letters may change
  const std::vector<Point>& region_corners() const { return corners_; }  // where edges of regions end or cross

  ltl::Letter label(Point p) const;  // of a point on the edge of a region, with or without that region
  bool contains(Point p) const override;
  bool admits(Point a, Point b, double radius) const override;
  double clearance(const Box& box, double most) const override;

 private:
  std::string name_;
  Polygon border_;
  std::vector<Polygon> obstacles_;
  std::vector<NamedRegion> regions_;
  std::vector<ltl::Proposition> named_;  // by region
  ltl::Vocabulary vocabulary_;
  std::vector<Edge> walls_, edges_;
  std::vector<Point> corners_;
  Point low_, high_;
};

}  // namespace waymark::plan
