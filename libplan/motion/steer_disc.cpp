#include "libplan/motion/steer_disc.hpp"

#include <algorithm>
#include <stdexcept>

namespace waymark::plan {
namespace {

// Paths are planned with this much more room than they are certified with, so that rounding decides nothing.
constexpr double margin = 1e-6;
constexpr int roundings = 3;  // times that every corner of a path is cut

Point nearest_to(Point target, const std::vector<Point>& points) {
  return *std::min_element(points.begin(), points.end(),
                           [&](Point a, Point b) { return distance(a, target) < distance(b, target); });
}

class Glider {
 public:
  Glider(const Trajectory& route, const Workspace& workspace, const Sampling& sampling)
      : route_(route),
        workspace_(workspace),
        sampling_(sampling),
        radius_(std::get<Disc>(sampling.robot).radius),
        room_(radius_ + margin) {}

  Realization run() {
    start();
    for (std::size_t i = 0; i < route_.actions.size();) {
      if (route_.actions[i] != Action::Forward) {
        append(position(motion_.configurations.back()), heading(++i));
        continue;
      }
      const std::size_t end = end_of_leg(i);
      if (!go(i, end)) return Unreached{route_.poses[i], route_.poses[end], sampling_.iterations};
      i = end;
    }
    return std::move(motion_);
  }

 private:
  int heading(std::size_t pose) const { return workspace_.map().pose(route_.poses[pose]).heading; }
  Point place(std::size_t pose) const { return workspace_.centre(node(pose)); }
  std::uint32_t node(std::size_t pose) const { return workspace_.map().node_of(route_.poses[pose]); }
  void append(Point p, int towards) { motion_.configurations.push_back({p.x, p.y, 1.0 * towards}); }

  std::size_t end_of_leg(std::size_t begin) const {
    while (begin < route_.actions.size() && route_.actions[begin] == Action::Forward) ++begin;
    return begin;
  }

  // Beside furniture the robot starts where its first leg is shortest.
  void start() {
    if (!(radius_ >= 0 && room_ < workspace_.width() / 2))
      throw std::invalid_argument("the radius of the robot must lie between 0 and half the width of a hallway");
    const std::vector<Point> stands = workspace_.stands(node(0), room_);
    if (stands.empty()) throw std::invalid_argument("the robot does not fit beside the furniture where it starts");
    const auto first = std::find(route_.actions.begin(), route_.actions.end(), Action::Forward);
    const auto leg = static_cast<std::size_t>(first - route_.actions.begin());
    motion_.robot = sampling_.robot;
    append(nearest_to(place(end_of_leg(leg)), stands), heading(0));
  }

  // Appends the leg from pose `begin` to pose `end`; false when no path was found.
  bool go(std::size_t begin, std::size_t end) {
    const Point from = position(motion_.configurations.back());
    const std::vector<Point> goals = workspace_.stands(node(end), room_);
    if (goals.empty()) return false;
    const auto free = [this](Point a, Point b) { return is_free(a, b); };
    std::vector<Point> path{from, nearest_to(from, goals)};
    if (!is_free(path[0], path[1])) path = rounded(tightened(sampled(begin, end, goals), free), free);
    const auto before = static_cast<std::ptrdiff_t>(motion_.configurations.size());
    for (std::size_t i = 1; i < path.size(); ++i) append(path[i], heading(end));
    const Motion leg{{motion_.configurations.begin() + before - 1, motion_.configurations.end()}, sampling_.robot};
    const auto read = route_of(leg, workspace_);  // a path that goes back to an earlier cell is no such leg
    const auto* actions = std::get_if<Trajectory>(&read);
    return actions != nullptr && actions->poses.back() == route_.poses[end] && actions->actions.size() == end - begin;
  }

  bool is_free(Point a, Point b) const { return workspace_.admits(a, b, room_); }

  std::vector<Point> sampled(std::size_t begin, std::size_t end, const std::vector<Point>& goals) {
    const Point a = place(begin), b = place(end);
    const double half = workspace_.width() / 2;
    const PathProblem problem{{std::min(a.x, b.x) - half, std::min(a.y, b.y) - half},
                              {std::max(a.x, b.x) + half, std::max(a.y, b.y) + half},
                              [this](Point p, Point q) { return is_free(p, q); },
                              position(motion_.configurations.back()),
                              goals};
    return sample_path(problem, sampling_budget(sampling_, begin));
  }

  const Trajectory& route_;
  const Workspace& workspace_;
  const Sampling& sampling_;
  double radius_, room_;
  Motion motion_;
};

}  // namespace

std::vector<Point> tightened(const std::vector<Point>& path, const std::function<bool(Point, Point)>& is_free) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < path.size();) {
    out.push_back(path[i]);
    std::size_t next = path.size();
    while (next > i + 2 && !is_free(path[i], path[next - 1])) --next;
    i = std::max(next - 1, i + 1);
  }
  return out;
}

std::vector<Point> rounded(std::vector<Point> path, const std::function<bool(Point, Point)>& is_free) {
  const auto between = [](Point a, Point b) { return Point{a.x + (b.x - a.x) / 4, a.y + (b.y - a.y) / 4}; };
  for (int round = 0; round < roundings; ++round) {
    std::vector<Point> out;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const bool corner = i > 0 && i + 1 < path.size();
      const Point in = corner ? between(path[i], path[i - 1]) : path[i];
      const Point away = corner ? between(path[i], path[i + 1]) : path[i];
      if (corner && is_free(in, away)) {
        out.insert(out.end(), {in, away});
      } else {
        out.push_back(path[i]);
      }
    }
    path = std::move(out);
  }
  return path;
}

Realization steer_disc(const Trajectory& route, const Workspace& workspace, const Sampling& sampling) {
  return Glider(route, workspace, sampling).run();
}

}  // namespace waymark::plan
