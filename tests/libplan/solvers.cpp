#include "tests/libplan/solvers.hpp"

#include <gtest/gtest.h>

#include <set>

#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/route_planner.hpp"

namespace waymark::plan {
namespace {

std::optional<Route> by_policy(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                               ShortestRoute::Algorithm algorithm) {
  const MapProduct product = compose(map, dfa, starts);
  const Outcome outcome = solve(product, {.algorithm = algorithm});
  EXPECT_FALSE(std::holds_alternative<Exhausted>(outcome));
  const auto* solved = std::get_if<Solved>(&outcome);
  if (solved == nullptr) return std::nullopt;
  Route route = roll_out(product, solved->policy);
  EXPECT_EQ(route.cost, solved->value);
  EXPECT_EQ(solved->lower, solved->value);
  EXPECT_EQ(solved->upper, solved->value);
  return route;
}

std::optional<Route> breadth_first(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts) {
  const auto answer = RoutePlanner(map, dfa).plan(starts);
  EXPECT_FALSE(std::holds_alternative<Exhausted>(answer));
  if (const auto* route = std::get_if<Route>(&answer)) return *route;
  return std::nullopt;
}

// The letter over the vocabulary of the formula, matched by name.
ltl::Letter seen(const Map& map, const ltl::Letter& letter, ltl::Formula f) {
  ltl::Letter out;
  for (ltl::Proposition p : ltl::propositions(f))
    if (letter.contains(map.vocabulary().find(f.arena().vocabulary().name(p)).value())) out.insert(p);
  return out;
}

}  // namespace

std::vector<Solver> all_solvers() {
  using enum ShortestRoute::Algorithm;
  return {{"Dijkstra on the product",
           [](auto& map, auto& dfa, auto starts) { return by_policy(map, dfa, starts, Dijkstra); }},
          {"A* on the product", [](auto& map, auto& dfa, auto starts) { return by_policy(map, dfa, starts, AStar); }},
          {"breadth first on the fly", breadth_first}};
}

std::optional<Trajectory> by_enumeration(const Map& map, ltl::Formula f, PoseId start, std::size_t length) {
  std::vector<Trajectory> layer{{{start}, {}}};
  for (std::size_t n = 0; n <= length; ++n) {
    for (const Trajectory& trajectory : layer)
      if (ltl::holds(word_for(f, trajectory, map), f)) return trajectory;
    std::vector<Trajectory> longer;
    for (const Trajectory& trajectory : layer) {
      for (Action action : all_actions) {
        const auto next = map.successor(trajectory.poses.back(), action);
        if (!next) continue;
        longer.push_back(trajectory);
        longer.back().poses.push_back(*next);
        longer.back().actions.push_back(action);
      }
    }
    layer = std::move(longer);
  }
  return std::nullopt;
}

Progressed by_progression(const Map& map, ltl::Formula f, PoseId start, std::size_t limit) {
  struct Entry {
    PoseId pose;
    ltl::Formula rest;
    std::size_t parent;
    Action by;
  };
  std::vector<Entry> queue{{start, ltl::progress(f, seen(map, map.label(start), f)), 0, Action::Forward}};
  std::set<std::pair<std::uint32_t, std::uint32_t>> known{{start.index, queue[0].rest.id()}};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (ltl::accepts_empty(queue[i].rest)) {
      std::vector<Action> actions;
      for (std::size_t k = i; k != 0; k = queue[k].parent) actions.insert(actions.begin(), queue[k].by);
      return {Proof::Found, follow(map, start, actions).value()};
    }
    if (queue.size() > limit) return {Proof::GaveUp, {}};
    for (Action action : all_actions) {
      const auto next = map.successor(queue[i].pose, action);
      if (!next) continue;
      const ltl::Formula rest = ltl::progress(queue[i].rest, seen(map, map.letter(*next, action), f));
      if (known.insert({next->index, rest.id()}).second) queue.push_back({*next, rest, i, action});
    }
  }
  return {Proof::None, {}};
}

std::string paste(const Map& map, ltl::Formula f, std::span<const PoseId> starts) {
  std::string out = "map " + map.name() + "  start";
  for (PoseId p : starts) out += " " + show(map.pose(p));
  return out + "  formula " + ltl::print(f);
}

}  // namespace waymark::plan
