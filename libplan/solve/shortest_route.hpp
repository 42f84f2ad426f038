// Least-cost routes in the product by Dijkstra or A* (Boost.Graph), ties broken by action order FORWARD, LEFT, RIGHT:
// among the least-cost routes the one whose action string is lexicographically least (conventions.md 4). With several
// start poses: the cheapest; among equally cheap ones the first given. For a route alone the product need not be built:
// route_planner.hpp.
#pragma once
#include <cstdint>
#include <stop_token>

#include "libplan/solve/outcome.hpp"

namespace waymark::plan {

struct ShortestRoute {
  // Dijkstra searches backwards from all accepting vertices at once: its policy is optimal from every vertex. [Dij59]
  // AStar searches forwards with LowerBound: its policy is set along the route only. [HNR68]
  enum class Algorithm : std::uint8_t { AStar, Dijkstra };
  Algorithm algorithm = Algorithm::AStar;
  std::stop_token stop = {};  // polled every few hundred vertices; then Exhausted
};

Outcome solve(const MapProduct& product, const ShortestRoute& method = {});  // Infeasible when no start has a route

}  // namespace waymark::plan
