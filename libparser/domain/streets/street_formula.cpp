#include "libparser/domain/streets/street_formula.hpp"

#include <algorithm>

#include "libparser/domain/streets/street_routes.hpp"

namespace waymark::streets {

std::optional<StreetRoute> waypoints(const StreetMap& map, const StreetRoute& route) {
  const std::vector<bool> nothing(map.landmarks.size(), false);
  StreetRoute named;
  for (std::size_t from = 0; from + 1 < route.size();) {
    std::size_t to = route.size() - 1;
    const auto shortest = [&] {
      const StreetRoute way = shortest_street_route(map, route[from], route[to], nothing);
      return way.size() == to - from + 1 &&
             std::equal(way.begin(), way.end(), route.begin() + static_cast<std::ptrdiff_t>(from));
    };
    while (to > from && !shortest()) --to;
    if (to == from) return std::nullopt;
    named.push_back(route[to]);
    from = to;
  }
  return named;
}

ltl::Formula visit_in_order(const StreetMap& map, const StreetRoute& landmarks, ltl::Arena& arena) {
  std::vector<ltl::Formula> atoms;  // made in their order, which is that of operands when they are printed
  for (const LandmarkIndex l : landmarks) atoms.push_back(arena.atom(plan::landmark_name(map.landmarks[l].name)));
  ltl::Formula task = arena.constant(true);
  for (auto at = atoms.rbegin(); at != atoms.rend(); ++at) task = ltl::eventually(ltl::conjunction(*at, task));
  return task;
}

}  // namespace waymark::streets
