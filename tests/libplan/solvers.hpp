// Every way to a least-cost route, in one table, and the referees they are held against: enumeration of all action
// strings, and breadth-first search over (pose × progressed formula), which knows no automaton.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/formula.hpp"
#include "libplan/solve/route.hpp"
#include "libplan/solve/shortest_route.hpp"

namespace waymark::plan {

struct Solver {
  std::string name;
  // The route from the starts that the solver answers with; nullopt: Infeasible. Exhausted fails the test.
  std::function<std::optional<Route>(const Map&, const automata::Dfa&, std::span<const PoseId>)> route;
};
std::vector<Solver> all_solvers();

// The first action string of at most `length` actions, shorter ones first, then FORWARD < LEFT < RIGHT, whose word
// satisfies f by definition. O(3^length).
std::optional<Trajectory> by_enumeration(const Map& map, ltl::Formula f, PoseId start, std::size_t length);

enum class Proof { Found, None, GaveUp };
struct Progressed {
  Proof proof;
  Trajectory route;
};
// The same by progression. None: every reachable (pose, progressed formula) was looked at. GaveUp: more than `limit`.
Progressed by_progression(const Map& map, ltl::Formula f, PoseId start, std::size_t limit);

// "map grid  start 1,9,0  formula F chair": what a failing case prints, ready to paste after `waymark plan`.
std::string paste(const Map& map, ltl::Formula f, std::span<const PoseId> starts);

}  // namespace waymark::plan
