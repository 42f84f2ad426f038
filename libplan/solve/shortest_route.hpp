// Least-cost routes in the product by Dijkstra or A* (Boost.Graph), ties broken by action order FORWARD, LEFT, RIGHT:
// among the least-cost routes the one whose action string is lexicographically least (conventions.md 4).
#pragma once
#include <cstdint>
#include <stop_token>

#include "libplan/solve/outcome.hpp"

namespace waymark::plan {

struct ShortestRoute {
  enum class Algorithm : std::uint8_t { AStar, Dijkstra };
  Algorithm algorithm = Algorithm::AStar;
  std::stop_token stop = {};
};

Outcome solve(const Product& product, const ShortestRoute& method);

}  // namespace waymark::plan
