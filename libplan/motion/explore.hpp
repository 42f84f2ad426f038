// Formula → motion in one search: OMPL's LTLPlanner on the product of our automaton with the cells of the workspace.
//
// There is no route before the motion. A symbol (ltl_bridge.hpp) is a pose, or a hallway with a heading. A state of the
// automaton is a state of 𝒜_φ and the pose last entered. A symbol that stands for an action of the map moves 𝒜_φ by the
// letter of that action; other symbols move nothing. X therefore counts actions, as on the map. A symbol that no action
// leads to ends the run. The letter of the start pose is read before the search. The robot is a disc or a car. The
// motion is far from shortest.
#pragma once
#include <cstdint>
#include <functional>
#include <variant>

#include "libautomata/finite/dfa.hpp"
#include "libplan/motion/ltl_bridge.hpp"
#include "libplan/motion/motion.hpp"

namespace waymark::plan {

struct Exploration {       // what is searched with
  double seconds = 30;     // of the clock: equal seeds need not give equal motions
  std::uint64_t seed = 1;  // of the sampling
  Robot robot = Disc{};    // that moves
};

struct NoRun {};       // proved: no run of the product accepts
struct OutOfTime {     // nothing proved
  double seconds = 0;  // 0: no way looks wide enough for the robot, and none was tried
};
using Explored = std::variant<Motion, NoRun, OutOfTime>;  // a motion, or why there is none

// A motion from the cell of that pose whose word the automaton accepts. Throws std::invalid_argument when the robot
// does not fit where it starts.
Explored explore(const automata::Dfa& dfa, const Workspace& workspace, PoseId start, const Exploration& how);

// What OMPL is told of the task: pose p is the symbol p, the hallway e with heading 90 h is 4 · (nodes + e) + h. Its
// start is the state after the letter of the start pose, and may accept.
SymbolAutomaton task_over_symbols(const automata::Dfa& dfa, const Workspace& workspace, PoseId start);

// Tries OMPL on the problem until `is_done` says that the line is a solution or the time is over.
Explored try_exploring(const ExplorationProblem& problem, const Exploration& how,
                       const std::function<bool(const Motion&)>& is_done);

}  // namespace waymark::plan
