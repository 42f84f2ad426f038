#include "libparser/domain/streets/street_walk.hpp"

#include <algorithm>

namespace waymark::streets {
namespace {

constexpr double never = 1e9;

// Of the first i mentions, when the walk has come to position p: least cost, and where it was before mention i − 1.
struct Table {
  Table(std::size_t mentions, std::size_t positions)
      : width(positions), cost((mentions + 1) * positions, never), before((mentions + 1) * positions, 0) {
    cost[0] = 0;
  }
  void offer(std::size_t i, std::uint32_t p, double c, std::uint32_t from) {
    if (c < cost[i * width + p]) cost[i * width + p] = c, before[i * width + p] = from;
  }
  std::size_t width;
  std::vector<double> cost;
  std::vector<std::uint32_t> before;
};

Table fill(const std::vector<PlacedMention>& mentions, std::size_t positions) {
  Table table(mentions.size(), positions);
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    const std::uint32_t here = mentions[i].position;
    for (std::uint32_t p = 0; p < positions; ++p) {
      const double so_far = table.cost[i * positions + p];
      if (so_far >= never) continue;
      table.offer(i + 1, p, so_far + (here == p ? 0 : cost_no_step), p);
      if (here != off_route && here > p)
        table.offer(i + 1, here, so_far + cost_unreached * static_cast<double>(here - p - 1), p);
    }
  }
  return table;
}

MentionRole no_step(const PlacedMention& mention, std::uint32_t at, const StreetRoute& rival) {
  if (mention.position == off_route)
    return stands_on(rival, mention.landmark) ? MentionRole::OnRival : MentionRole::Unseen;
  if (mention.position == at) return MentionRole::Stays;
  if (mention.position > at) return MentionRole::Ahead;
  return mention.position == 0 ? MentionRole::AtStart : MentionRole::Behind;
}

}  // namespace

bool stands_on(const StreetRoute& route, LandmarkIndex landmark) {
  return std::find(route.begin(), route.end(), landmark) != route.end();
}

Walk walk_along(const CandidateRoute& route, const std::vector<PlacedMention>& mentions) {
  const std::size_t n = mentions.size(), positions = route.landmarks.size();
  const Table table = fill(mentions, positions);
  Walk walk;
  walk.cost = never;
  std::uint32_t at = 0;
  for (std::uint32_t p = 0; p < positions; ++p) {
    const double cost = table.cost[n * positions + p] + cost_unreached * static_cast<double>(positions - 1 - p);
    if (cost < walk.cost) walk.cost = cost, at = p;
  }
  walk.reaches_goal = at + 1 == positions;
  walk.unreached = positions - 1;
  walk.steps.resize(n);
  for (std::size_t i = n; i-- > 0;) {
    const std::uint32_t before = table.before[(i + 1) * positions + at];
    walk.steps[i] = before == at ? no_step(mentions[i], at, route.rival) : MentionRole::GoesOn;
    walk.unreached -= before == at ? 0U : 1U;
    at = before;
  }
  return walk;
}

}  // namespace waymark::streets
