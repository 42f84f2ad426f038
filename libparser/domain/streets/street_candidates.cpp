#include "libparser/domain/streets/street_candidates.hpp"

#include <algorithm>

namespace waymark::streets {
namespace {

// Settings of the rough count: it only has to keep the right route among many.
constexpr double own_landmark = 2.5;  // letters by which a name may fit worse if its landmark lies on the route
constexpr double unnamed = 1.0, elsewhere = 1.0, backwards = 0.6, skipped = 0.15, wrong_goal = 0.8, by_rank = 0.06;

double rough_score(const CandidateRoute& route, const std::vector<PlacedMention>& mentions) {
  std::vector<bool> named(route.landmarks.size(), false);
  named[0] = true;
  double score = -by_rank * route.rank;
  std::uint32_t last = 0;
  for (const PlacedMention& mention : mentions) {
    if (mention.position == off_route) {
      score -= elsewhere;
      continue;
    }
    if (mention.position < last) score -= backwards;
    if (mention.position > last + 1) score -= skipped;
    last = mention.position;
    named[mention.position] = true;
  }
  score -= unnamed * static_cast<double>(std::count(named.begin(), named.end(), false));
  if (last + 1 != route.landmarks.size()) score -= wrong_goal;
  return score;
}

}  // namespace

std::vector<PlacedMention> place(const std::vector<Mention>& mentions, const StreetRoute& route) {
  std::vector<PlacedMention> placed;
  for (const Mention& mention : mentions) {
    PlacedMention best;
    double score = -1e9;
    for (const NameFit& fit : mention.fits) {
      const auto at = std::find(route.begin(), route.end(), fit.landmark);
      const double here = fit.letters + (at != route.end() ? own_landmark : 0);
      if (here <= score) continue;
      score = here;
      best = {fit.landmark, at == route.end() ? off_route : static_cast<std::uint32_t>(at - route.begin()), fit.letters,
              fit.complete};
    }
    placed.push_back(best);
  }
  return placed;
}

std::vector<CandidateRoute> candidate_routes(const StreetMap& map, RouteTable& routes, LandmarkIndex start,
                                             const std::vector<Mention>& mentions, const CandidateLimits& limits) {
  struct Scored {
    double score;
    LandmarkIndex goal;
    std::uint32_t rank;
  };
  std::vector<Scored> scored;
  for (LandmarkIndex goal = 0; goal < map.landmarks.size(); ++goal) {
    if (goal == start) continue;
    const auto& ranked = routes.routes(start, goal);
    for (std::uint32_t rank = 0; rank < ranked.size(); ++rank) {
      const CandidateRoute route{ranked[rank].landmarks, rank, ranked[rank].length, ranked[0].length, {}};
      scored.push_back({rough_score(route, place(mentions, route.landmarks)), goal, rank});
    }
  }
  const std::size_t kept = std::min(limits.candidates, scored.size());
  std::stable_sort(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) { return a.score > b.score; });
  std::vector<CandidateRoute> out;
  for (std::size_t i = 0; i < kept; ++i) {
    const auto& ranked = routes.routes(start, scored[i].goal);
    const RankedRoute& route = ranked[scored[i].rank];
    const bool last = scored[i].rank + 1 == ranked.size();
    out.push_back({route.landmarks, scored[i].rank, route.length, ranked[0].length,
                   last ? StreetRoute{} : ranked[scored[i].rank + 1].landmarks});
  }
  return out;
}

}  // namespace waymark::streets
