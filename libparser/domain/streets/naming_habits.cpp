#include "libparser/domain/streets/naming_habits.hpp"

#include <algorithm>
#include <set>

#include "libparser/domain/streets/route_prior.hpp"

namespace waymark::streets {
namespace {

constexpr double shrunk = 10;  // texts

WayEnds way(LandmarkIndex a, LandmarkIndex b) { return std::minmax(a, b); }

struct Counts {
  explicit Counts(std::size_t landmarks) : landmark(landmarks, 0.0) {}
  std::vector<double> landmark;
  std::map<WayEnds, double> ways;
};

Counts count_names(std::size_t landmarks, std::span<const UnreadText> texts) {
  Counts counts(landmarks);
  for (const UnreadText& text : texts) {
    std::set<LandmarkIndex> named;
    std::set<WayEnds> said;
    LandmarkIndex last = text.start;
    for (const LandmarkIndex l : text.named) {
      if (l != text.start) named.insert(l);
      if (l != last) said.insert(way(last, l));
      last = l;
    }
    for (const LandmarkIndex l : named) ++counts.landmark[l];
    for (const WayEnds& w : said) ++counts.ways[w];
  }
  return counts;
}

// Texts that start there, goals all alike.
void expect_from(Counts& counts, RouteTable& routes, LandmarkIndex start, double texts) {
  const std::size_t landmarks = counts.landmark.size();
  std::size_t goals = 0;
  for (LandmarkIndex goal = 0; goal < landmarks; ++goal)
    goals += goal != start && !routes.routes(start, goal).empty() ? 1U : 0U;
  for (LandmarkIndex goal = 0; goal < landmarks; ++goal) {
    if (goal == start) continue;
    const auto& ranked = routes.routes(start, goal);
    for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
      const double share =
          texts / static_cast<double>(goals) * rank_probability(rank, ranked.size(), routes.most());
      const StreetRoute& route = ranked[rank].landmarks;
      for (std::size_t i = 1; i < route.size(); ++i) {
        counts.landmark[route[i]] += share;
        counts.ways[way(route[i - 1], route[i])] += share;
      }
    }
  }
}

double over(double found, double expected, double otherwise) {
  return expected > 0 ? found / expected : otherwise;
}

}  // namespace

NamingHabits naming_habits(const StreetMap& map, RouteTable& routes, std::span<const UnreadText> texts) {
  const std::size_t n = map.landmarks.size();
  const Counts found = count_names(n, texts);
  Counts expected(n);
  std::vector<double> starts(n, 0.0);
  for (const UnreadText& text : texts) ++starts[text.start];
  for (LandmarkIndex start = 0; start < n; ++start)
    if (starts[start] > 0) expect_from(expected, routes, start, starts[start]);
  const auto said = [&](const WayEnds& w) {
    const auto at = found.ways.find(w);
    return at == found.ways.end() ? 0.0 : at->second;
  };
  double all_found = 0, all_expected = 0, all_said = 0, all_taken = 0;
  for (std::size_t l = 0; l < n; ++l) all_found += found.landmark[l], all_expected += expected.landmark[l];
  for (const auto& [w, times] : expected.ways) all_said += said(w), all_taken += times;
  NamingHabits habits;
  habits.usual_named = over(all_found, all_expected, 1);
  habits.usual_said = over(all_said, all_taken, 1);
  for (std::size_t l = 0; l < n; ++l)
    habits.named.push_back((found.landmark[l] + shrunk * habits.usual_named) /
                           (expected.landmark[l] + shrunk));
  for (const auto& [w, times] : expected.ways)
    habits.said[w] = (said(w) + shrunk * habits.usual_said) / (times + shrunk);
  return habits;
}

}  // namespace waymark::streets
