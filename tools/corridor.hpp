// The corridor from a task to a certified route, stage by stage, each with its size and its time.
//
// One way through for every subcommand: task → automaton → product → outcome → route → certificate. Whoever shows a
// route got it here, so no route is shown that was not certified.
#pragma once
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <variant>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libltl/formula.hpp"
#include "libplan/solve/outcome.hpp"
#include "tools/shown_route.hpp"

namespace waymark::tools {

class StopWatch {
 public:
  double lap();  // seconds since construction or the last lap

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

struct Seconds {
  double load = 0, ground = 0, translate = 0, compose = 0, solve = 0, certify = 0;
  double total() const { return load + ground + translate + compose + solve + certify; }
};

struct AutomatonSize {
  std::size_t states = 0, edges = 0, symbolic_nodes = 0, propositions = 0;
};
AutomatonSize size_of(const automata::Dfa& dfa);

// φ → 𝒜_φ. Throws Interrupted when a stop was requested.
automata::Dfa translate(ltl::Formula formula, const std::stop_token& stop);

using Destination = std::variant<CheckedRoute, plan::Infeasible>;

struct CorridorRun {
  AutomatonSize automaton;
  std::size_t product_states, product_edges;  // pairs that the search met, edges that it looked at
  Destination destination;
  Seconds seconds;  // of compose, solve and certify; the caller adds the stages before
  std::vector<plan::PoseId> starts = {};
};

// The certified route of least cost. `formula`: of the automaton, when there is one; without it the route is checked
// against the automaton by a run of its own. Throws Interrupted when a stop was requested.
CorridorRun run_corridor(const plan::Map& map, const automata::Dfa& dfa, std::optional<ltl::Formula> formula,
                         std::span<const plan::PoseId> starts, const std::stop_token& stop);

// The route that was found, nullptr when there is none; and the same for pictures and printers.
const plan::Route* route_of(const CorridorRun& corridor_run);
std::optional<ShownRoute> shown(const CorridorRun& corridor_run);

}  // namespace waymark::tools
