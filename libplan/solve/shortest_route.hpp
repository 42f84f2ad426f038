// Least-cost routes in the product by Dijkstra or A* (Boost.Graph), ties broken by action order FORWARD, LEFT, RIGHT:
// among the least-cost routes the one whose action string is lexicographically least (conventions.md 4). With several
// start poses: the cheapest; among equally cheap ones the first given.
#pragma once
#include <cstdint>
#include <span>
#include <stop_token>
#include <variant>

#include "libplan/product/implicit.hpp"
#include "libplan/solve/lower_bound.hpp"
#include "libplan/solve/outcome.hpp"
#include "libplan/solve/route.hpp"

namespace waymark::plan {

struct ShortestRoute {
  // Dijkstra searches backwards from all accepting vertices at once: its policy is optimal from every vertex. [Dij59]
  // AStar searches forwards with LowerBound: its policy is set along the route only. [HNR68]
  enum class Algorithm : std::uint8_t { AStar, Dijkstra };
  Algorithm algorithm = Algorithm::AStar;
  std::stop_token stop = {};  // polled every few hundred vertices; then Exhausted
};

Outcome solve(const Product& product, const ShortestRoute& method = {});

// The same answer without building the product: A* on ImplicitProduct. One planner serves one task on one map and may
// be asked about many starts, which then share all that was learnt (steps, bounds, vertices). Map and automaton must
// outlive it; one thread at a time.
class RoutePlanner {
 public:
  using Answer = std::variant<Route, Infeasible, Exhausted>;

  RoutePlanner(const Map& map,
               const automata::Dfa& dfa);      // throws ltl::FormatError on a proposition the map lacks
  RoutePlanner(const RoutePlanner&) = delete;  // parts point to each other
  RoutePlanner& operator=(const RoutePlanner&) = delete;

  Answer plan(std::span<const PoseId> starts, std::stop_token stop = {});
  Answer plan(PoseId start, std::stop_token stop = {}) { return plan({&start, 1}, std::move(stop)); }

  std::size_t discovered() const { return product_.discovered(); }  // product vertices made so far
  std::size_t expanded() const { return expanded_; }                // by the last plan

 private:
  TaskSteps steps_;
  LowerBound bound_;
  ImplicitProduct product_;
  std::size_t expanded_ = 0;
};

}  // namespace waymark::plan
