// The interface to OMPL's control::LTLPlanner [BKV10, MLKKV13], which grows a tree of motions along runs of a product.
//
// The planner reads one letter for every step of propagation, and its translation of formulas, its guards and its start
// differ from our conventions. It therefore gets no formula, but an automaton over *symbols*: a symbol names the part
// of the space that contains the robot. The automaton stores the last symbol and moves only when another symbol is
// read. This avoids the pitfalls of OMPL 1.5.2. Guards are complete letters (the number of one symbol in binary), hence
// disjoint. The maker of the automaton reads the symbol of the start. X counts symbols and not steps. A symbol without
// a transition ends the run. The planner has a budget in seconds and iterates over hash tables of addresses, so equal
// seeds may give different motions.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "libplan/motion/robot.hpp"

namespace waymark::plan {

struct SymbolAutomaton {
  struct Transition {              // on a symbol
    std::uint32_t symbol, target;  // what is read, where it leads
  };
  std::vector<std::vector<Transition>> transitions;  // by state; at most one for each symbol
  std::vector<bool> accepting;                       // the task is done on the way into such a state
  std::uint32_t start = 0;                           // not accepting
};

struct Region {                 // of the workspace, with one symbol
  std::uint32_t symbol = 0;     // that is read inside
  double volume = 1;            // for the choice of regions
  std::vector<int> neighbours;  // regions
};

struct ExplorationProblem {                                                     // what OMPL is to solve
  SymbolAutomaton task;                                                         // over symbols
  std::vector<Region> regions;                                                  // of the whole workspace
  std::function<std::optional<std::uint32_t>(const Configuration&)> region_of;  // nothing: not free
  std::function<bool(const Configuration&, const Configuration&)> is_free;      // one piece of motion
  Point low, high;                                                              // all positions lie between
  double step = 0.04;                                                           // of propagation: its length, at most
  Robot robot;                                                                  // that moves
  Configuration start;                                                          // where it stands
};

// Whether some run of the automaton goes from region to neighbouring region to acceptance: where none does, no motion
// solves the task. OMPL must not be asked then: it ends by a segmentation fault.
bool has_run(const ExplorationProblem& problem);

// A line of configurations that ends where the task is done, joined by pieces of motion of the robot; empty when the
// time is over first. has_run(problem). Silences OMPL's messages for the whole process.
std::vector<Configuration> explore(const ExplorationProblem& problem, double seconds, std::uint32_t seed);

}  // namespace waymark::plan
