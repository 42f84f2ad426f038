#include "libplan/motion/terrain.hpp"

#include <algorithm>
#include <stdexcept>

namespace waymark::plan {
namespace {

void check(const Polygon& polygon, const std::string& what) {
  if (polygon.size() < 3) throw std::invalid_argument(what + ": a polygon has at least three corners");
  if (meets_itself(polygon)) throw std::invalid_argument(what + ": the polygon meets itself");
  if (signed_area(polygon) == 0) throw std::invalid_argument(what + ": the polygon has no area");
}

void add_edges(const Polygon& polygon, std::vector<Terrain::Edge>& out) {
  for (std::size_t i = 0; i < polygon.size(); ++i) out.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
}

std::vector<Point> corners_of(const std::vector<Terrain::Edge>& edges) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [a, b] = edges[i];
    corners.push_back(a);
    for (std::size_t j = 0; j < i; ++j) {
      const auto [c, d] = edges[j];
      const bool parallel = (b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x);
      if (!parallel && distance(a, b, c, d) == 0) corners.push_back(meeting(a, b, c, d));
    }
  }
  return corners;
}

}  // namespace

Terrain::Terrain(std::string name, Polygon border, std::vector<Polygon> obstacles, std::vector<NamedRegion> regions)
    : name_(std::move(name)),
      border_(std::move(border)),
      obstacles_(std::move(obstacles)),
      regions_(std::move(regions)) {
  check(border_, "boundary");
  for (std::size_t i = 0; i < obstacles_.size(); ++i) check(obstacles_[i], "obstacles[" + std::to_string(i) + "]");
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const std::string what = "regions[" + std::to_string(i) + "]";
    if (regions_[i].name.empty()) throw std::invalid_argument(what + ": a region has a name");
    check(regions_[i].border, what + ".polygon");
    named_.push_back(vocabulary_.add(regions_[i].name));
    add_edges(regions_[i].border, edges_);
  }
  add_edges(border_, walls_);
  for (const Polygon& obstacle : obstacles_) add_edges(obstacle, walls_);
  corners_ = corners_of(edges_);
  low_ = high_ = border_[0];
  for (const Point& p : border_) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
}

ltl::Letter Terrain::label(Point p) const {
  ltl::Letter letter;
  for (std::size_t i = 0; i < regions_.size(); ++i)
    if (plan::contains(regions_[i].border, p)) letter.insert(named_[i]);
  return letter;
}

bool Terrain::contains(Point p) const {
  return plan::contains(border_, p) && std::none_of(obstacles_.begin(), obstacles_.end(), [&](const Polygon& obstacle) {
           return plan::contains(obstacle, p);
         });
}

// Starting in the free space and staying off its border is staying in it.
bool Terrain::admits(Point a, Point b, double radius) const {
  return radius >= 0 && contains(a) && std::none_of(walls_.begin(), walls_.end(), [&](const Edge& wall) {
           const double d = distance(a, b, wall.a, wall.b);
           return d < radius || d <= 0;
         });
}

double Terrain::clearance(const Box& box, double most) const {
  const Point middle{(box[0].x + box[2].x) / 2, (box[0].y + box[2].y) / 2};
  const double radius = distance(middle, box[0]);
  double least = most;
  for (const Edge& wall : walls_)
    if (distance(middle, wall.a, wall.b) - radius < least) least = std::min(least, gap(box, wall.a, wall.b));
  return least;
}

}  // namespace waymark::plan
