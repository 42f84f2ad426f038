#include "libplan/motion/workspace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace waymark::plan {
namespace {

constexpr std::array<Point, 4> directions{Point{0, -1}, Point{1, 0}, Point{0, 1}, Point{-1, 0}};  // heading / 90

}  // namespace

Workspace::Workspace(const Map& map, const WorkspaceShape& shape) : map_(&map), shape_(shape) {
  if (!(shape.width > 0 && shape.width < 1))
    throw std::invalid_argument("the width of hallways must lie between 0 and 1, the distance of two places");
  if (!(shape.furniture >= 0 && shape.furniture < shape.width / 2))
    throw std::invalid_argument("the radius of furniture must lie between 0 and half the width of a hallway");
  for (std::uint32_t node = 0; node < map.nodes().size(); ++node) walls_.push_back(walls_around(node));
}

std::vector<Workspace::Wall> Workspace::walls_around(std::uint32_t node) const {
  const Point c = centre(node);
  const double half = shape_.width / 2;
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point ahead = directions[i], right = directions[(i + 1) % 4];
    // `forward` ahead of the centre and `sideways` to the right of it
    const auto at = [&](double forward, double sideways) {
      return Point{c.x + forward * ahead.x + sideways * right.x, c.y + forward * ahead.y + sideways * right.y};
    };
    if (map_->hallway(node, 90 * static_cast<int>(i)) == nullptr) {
      walls.push_back({at(half, -half), at(half, half)});
    } else {
      walls.push_back({at(half, -half), at(1 - half, -half)});
      walls.push_back({at(half, half), at(1 - half, half)});
    }
  }
  return walls;
}

Point Workspace::centre(std::uint32_t node) const {
  const Node& n = map_->nodes()[node];
  return {static_cast<double>(n.x), static_cast<double>(n.y)};
}

std::optional<Cell> Workspace::cell_at(Point p) const {
  constexpr double bound = Hallways::max_coordinate + 1.0;
  if (!(std::abs(p.x) < bound && std::abs(p.y) < bound)) return std::nullopt;
  const auto x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
  const auto node = map_->hallways().node_at(x, y);
  if (!node) return std::nullopt;
  const double half = shape_.width / 2, dx = p.x - x, dy = p.y - y;
  if (std::abs(dx) <= half && std::abs(dy) <= half) return Cell{Cell::Kind::Node, *node};
  if (std::abs(dx) > half && std::abs(dy) > half) return std::nullopt;
  const int heading = std::abs(dx) > half ? (dx > 0 ? 90 : 270) : (dy > 0 ? 180 : 0);
  const Edge* edge = map_->hallway(*node, heading);
  if (edge == nullptr) return std::nullopt;
  return Cell{Cell::Kind::Edge, static_cast<std::uint32_t>(edge - map_->edges().data())};
}

bool Workspace::is_furnished(std::uint32_t node) const {
  return shape_.furniture > 0 && map_->nodes()[node].object.has_value();
}

bool Workspace::keeps_off(std::uint32_t node, Point a, Point b, double radius) const {
  const double gap = distance(centre(node), a, b) - shape_.furniture;
  if (is_furnished(node) && (gap < radius || gap <= 0)) return false;
  return std::none_of(walls_[node].begin(), walls_[node].end(), [&](const Wall& wall) {
    const double d = distance(a, b, wall.a, wall.b);
    return d < radius || d <= 0;
  });
}

// Starting in the free space and staying off its border is staying in it. A disc narrower than a hallway touches
// only walls of nodes that are less than 1 away from the segment in both coordinates.
bool Workspace::admits(Point a, Point b, double radius) const {
  if (!(radius >= 0 && radius < shape_.width / 2) || !cell_at(a) || !cell_at(b)) return false;
  const auto y_at = [&](double x) {  // on the segment, at its end where x lies beyond
    return a.y + (b.y - a.y) * std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0);
  };
  const auto low = [](double u, double v) { return static_cast<int>(std::floor(std::min(u, v))); };
  const auto high = [](double u, double v) { return static_cast<int>(std::ceil(std::max(u, v))); };
  for (int x = low(a.x, b.x); x <= high(a.x, b.x); ++x) {
    const double from = a.x == b.x ? a.y : y_at(x - 1), to = a.x == b.x ? b.y : y_at(x + 1);
    for (int y = low(from, to); y <= high(from, to); ++y) {
      const auto node = map_->hallways().node_at(x, y);
      if (node && !keeps_off(*node, a, b, radius)) return false;
    }
  }
  return true;
}

// Every wall is one of the nodes at its two ends, so those around the box, widened by `most`, have all that count.
double Workspace::clearance(const Box& box, double most) const {
  const auto [left, right] = std::minmax({box[0].x, box[1].x, box[2].x, box[3].x});
  const auto [top, bottom] = std::minmax({box[0].y, box[1].y, box[2].y, box[3].y});
  const Point middle{(box[0].x + box[2].x) / 2, (box[0].y + box[2].y) / 2};
  const double radius = distance(middle, box[0]);
  const auto nearest = [](double value) { return static_cast<int>(std::lround(value)); };
  double least = most;
  for (int x = nearest(left - most); x <= nearest(right + most); ++x)
    for (int y = nearest(top - most); y <= nearest(bottom + most); ++y) {
      const auto node = map_->hallways().node_at(x, y);
      if (!node) continue;
      if (is_furnished(*node)) least = std::min(least, std::max(0.0, gap(box, centre(*node)) - shape_.furniture));
      for (const Wall& wall : walls_[*node])
        if (distance(middle, wall.a, wall.b) - radius < least) least = std::min(least, gap(box, wall.a, wall.b));
    }
  return least;
}

std::vector<Point> Workspace::stands(std::uint32_t node, double radius) const {
  const Point c = centre(node);
  const double nearest = shape_.furniture + radius, half = shape_.width / 2;
  std::vector<Point> candidates{c};
  // Around the furniture: half way between touching it and touching a wall, or the border of the cell.
  for (double away : {(nearest + half - radius) / 2, (nearest + half) / 2})
    for (std::size_t i = 0; i < 4; ++i) {
      const Point ahead = directions[i], right = directions[(i + 1) % 4];
      candidates.push_back({c.x + away * ahead.x, c.y + away * ahead.y});
      candidates.push_back({c.x + away * (ahead.x + right.x), c.y + away * (ahead.y + right.y)});
    }
  const Cell here{Cell::Kind::Node, node};
  std::vector<Point> out;
  for (const Point& p : candidates)
    if (out.empty() || out.front() != c)
      if (cell_at(p) == here && admits(p, radius)) out.push_back(p);
  return out;
}

}  // namespace waymark::plan
