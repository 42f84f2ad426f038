#include "libplan/motion/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan {
namespace {

bool cross(Point a, Point b, Point c,
           Point d) {  // properly: each segment has its ends on both sides of the other
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

}  // namespace

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

double distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  if (square == 0) return distance(p, a);
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
  return distance(p, {a.x + t * dx, a.y + t * dy});
}

double distance(Point a, Point b, Point c, Point d) {
  if (cross(a, b, c, d)) return 0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

double orientation(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool contains(const Box& box, Point p) {
  bool left = true, right = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = orientation(box[i], box[(i + 1) % 4], p);
    left = left && side <= 0;
    right = right && side >= 0;
  }
  return left || right;
}

double gap(const Box& box, Point p) {
  if (contains(box, p)) return 0;
  double least = distance(p, box[3], box[0]);
  for (std::size_t i = 0; i < 3; ++i) least = std::min(least, distance(p, box[i], box[i + 1]));
  return least;
}

double gap(const Box& box, Point a, Point b) {
  if (contains(box, a) || contains(box, b)) return 0;
  double least = distance(a, b, box[3], box[0]);
  for (std::size_t i = 0; i < 3; ++i) least = std::min(least, distance(a, b, box[i], box[i + 1]));
  return least;
}

bool contains(const Polygon& polygon, Point p) {  // a ray to the east meets the border an odd number of times
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += orientation(polygon[0], polygon[i], polygon[i + 1]);
  return twice / 2;
}

bool meets_itself(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  const auto corner = [&](std::size_t i) { return polygon[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = corner(i), b = corner(i + 1), c = corner(i + 2);
    const bool straight = orientation(a, b, c) == 0;
    if (a == b || (straight && (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) > 0)) return true;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && distance(a, b, corner(j), corner(j + 1)) == 0) return true;
  }
  return false;
}

Point meeting(Point a, Point b, Point c, Point d) {
  const double from = orientation(c, d, a), to = orientation(c, d, b), t = from / (from - to);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace waymark::plan
