// Least-cost routes on a map, breadth first over pairs of pose and task that come into being when they are met.
//
// All actions of a map cost the same (map.hpp), so the first accepting pair that is met ends a least-cost route. Pairs
// are met in the order of (number of actions, start, action string), for those of a layer are expanded in the order in
// which they were met and in action order FORWARD, LEFT, RIGHT: hence the parents of a pair spell the first of its
// least-cost routes, and the route is the one of conventions.md 4 without a second pass. A bit for every pair that
// could be met with a task that was, sixteen bytes for one that was met. (A* with LowerBound expands fewer pairs, but
// bounds cost a search of the whole map for every state of the task: more than looking at its pairs. docs/planning.md
// has the numbers.)
//
// The search is our own: bench_search, 512 plans on the map grid, ms of processor time in one run: this 0.66,
// Boost.Graph's breadth_first_visit on the same product, arrays kept between plans, 1.15.
#pragma once
#include <cstdint>
#include <span>
#include <stop_token>
#include <variant>
#include <vector>

#include "libplan/model/map_mdp.hpp"
#include "libplan/product/product.hpp"
#include "libplan/product/task_steps.hpp"
#include "libplan/solve/outcome.hpp"
#include "libplan/solve/route.hpp"

namespace waymark::plan {

// One planner serves one task on one map and may be asked about many starts, which then share the steps of the task.
// Map and automaton must outlive it; one thread at a time.
class RoutePlanner {
 public:
  using Result = std::variant<Route, Infeasible, Exhausted>;  // of one search

  // Throws ltl::FormatError on a proposition that the map lacks.
  RoutePlanner(const Map& map, const automata::Dfa& dfa);

  // The cheapest over all starts; among equally cheap ones of the first start given. (conventions.md 8)
  Result plan(std::span<const PoseId> starts, const std::stop_token& stop = {});
  Result plan(PoseId start, const std::stop_token& stop = {}) { return plan({&start, 1}, stop); }

  std::size_t met() const { return met_.size(); }  // pairs, by the last plan
  std::size_t edges() const { return edges_; }     // looked at

 private:
  struct Met {
    ProductState state;
    std::uint32_t from;  // in met_
    std::uint32_t choice = 0;
  };
  static constexpr std::uint32_t none = UINT32_MAX;

  void forget();
  bool meet(const Met& pair);                  // true: it is new and accepting
  bool expand(std::uint32_t i);                // true: it met an accepting pair
  Route route() const;                         // to the pair met last
  std::uint64_t* bits_of(std::uint32_t task);  // by pose

  TaskSteps task_;
  MapMdp model_;
  std::size_t words_;               // of a row of bits
  std::vector<std::uint32_t> row_;  // by state: the number of its row in seen_
  std::vector<std::uint64_t> seen_;
  std::vector<Met> met_;
  std::size_t edges_ = 0;
};

}  // namespace waymark::plan
