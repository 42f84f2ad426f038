#include "libparser/domain/streets/street_routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace waymark::streets {
namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();

// Dijkstra from `start` to `goal` over landmarks that are not closed, without the ways start → closed_ways.
// Maps are small: the next landmark is found by looking at all of them. O(landmarks²).
StreetRoute shortest(const StreetMap& map, LandmarkIndex start, LandmarkIndex goal, const std::vector<bool>& closed,
                     const std::set<LandmarkIndex>& closed_ways) {
  const std::size_t n = map.landmarks.size();
  std::vector<double> length(n, unreachable);
  std::vector<LandmarkIndex> before(n, start);
  std::vector<bool> done(n, false);
  length[start] = 0;
  while (true) {
    std::size_t at = n;
    for (std::size_t i = 0; i < n; ++i)
      if (!done[i] && length[i] < unreachable && (at == n || length[i] < length[at])) at = i;
    if (at == n) return {};
    if (at == goal) break;
    done[at] = true;
    for (const Way& way : map.ways[at]) {
      if (closed[way.to] || (at == start && closed_ways.contains(way.to))) continue;
      if (length[at] + way.length >= length[way.to]) continue;
      length[way.to] = length[at] + way.length;
      before[way.to] = static_cast<LandmarkIndex>(at);
    }
  }
  StreetRoute route{goal};
  while (route.back() != start) route.push_back(before[route.back()]);
  std::reverse(route.begin(), route.end());
  return route;
}

double length_of(const StreetMap& map, const StreetRoute& route) {
  double sum = 0;
  for (std::size_t i = 1; i < route.size(); ++i) sum += map.length(route[i - 1], route[i]).value_or(unreachable);
  return sum;
}

using Waiting = std::set<std::pair<double, StreetRoute>>;

// The spurs of the last route found: from each of its landmarks, the shortest way on that no route found yet takes.
void add_spurs(const StreetMap& map, const std::vector<RankedRoute>& found, Waiting& waiting) {
  const StreetRoute& last = found.back().landmarks;
  std::vector<bool> closed(map.landmarks.size(), false);
  for (std::size_t i = 0; i + 1 < last.size(); ++i) {
    const auto spur = static_cast<std::ptrdiff_t>(i);
    std::set<LandmarkIndex> taken;
    for (const RankedRoute& other : found) {
      const StreetRoute& route = other.landmarks;
      if (route.size() > i + 1 && std::equal(last.begin(), last.begin() + spur + 1, route.begin()))
        taken.insert(route[i + 1]);
    }
    StreetRoute rest = shortest(map, last[i], last.back(), closed, taken);
    if (!rest.empty()) {
      rest.insert(rest.begin(), last.begin(), last.begin() + spur);
      const double length = length_of(map, rest);
      waiting.emplace(length, std::move(rest));
    }
    closed[last[i]] = true;
  }
}

}  // namespace

std::vector<RankedRoute> shortest_simple_routes(const StreetMap& map, LandmarkIndex start, LandmarkIndex goal,
                                                std::size_t k) {
  std::vector<RankedRoute> found;
  if (k == 0) return found;
  StreetRoute first = shortest(map, start, goal, std::vector<bool>(map.landmarks.size(), false), {});
  if (first.empty()) return found;
  const double length = length_of(map, first);
  found.push_back({std::move(first), length});
  Waiting waiting;
  while (found.size() < k) {
    add_spurs(map, found, waiting);
    if (waiting.empty()) break;
    auto next = waiting.extract(waiting.begin());
    found.push_back({std::move(next.value().second), next.value().first});
  }
  return found;
}

StreetRoute shortest_street_route(const StreetMap& map, LandmarkIndex start, LandmarkIndex goal,
                                  const std::vector<bool>& avoided) {
  std::vector<bool> closed = avoided;
  closed[start] = closed[goal] = false;
  return shortest(map, start, goal, closed, {});
}

double distance_from(const StreetMap& map, const StreetRoute& route, LandmarkIndex landmark) {
  const Landmark& p = map.landmarks[landmark];
  double best = unreachable;
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Landmark &a = map.landmarks[route[i - 1]], &b = map.landmarks[route[i]];
    const double dx = b.right - a.right, dy = b.up - a.up, square = dx * dx + dy * dy;
    const double t = square == 0 ? 0 : ((p.right - a.right) * dx + (p.up - a.up) * dy) / square;
    const double s = std::clamp(t, 0.0, 1.0);
    best = std::min(best, std::hypot(a.right + s * dx - p.right, a.up + s * dy - p.up));
  }
  return best;
}

const std::vector<RankedRoute>& RouteTable::routes(LandmarkIndex start, LandmarkIndex goal) {
  const auto [at, fresh] = routes_.try_emplace({start, goal});
  if (fresh) at->second = shortest_simple_routes(*map_, start, goal, k_);
  return at->second;
}

}  // namespace waymark::streets
