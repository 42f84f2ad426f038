// The door to OMPL's control::LTLPlanner [BKV10, MLKKV13]: a tree of motions grown along runs of a product.
//
// The planner reads one world for every step of propagation, and its own translation of formulas, guards and start
// differ from what we mean. So it is not told the formula: it gets an automaton over *symbols*, each of which names
// what can be told apart about where the robot is. The automaton remembers the last symbol and moves only when another
// one is read; what it does then is ours to say. Of the traps of OMPL 1.5.2 this leaves none: guards are complete
// worlds (the number of one symbol in binary), hence disjoint; the symbol of the start is read by whoever makes the
// automaton; X counts symbols and not steps; a symbol without transition is a run that ends.
// The planner runs by the clock and follows hash tables of addresses: equal seeds need not give equal motions.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "libplan/motion/robot.hpp"

namespace waymark::plan {

struct SymbolAutomaton {
  struct Transition {
    std::uint32_t symbol, target;
  };
  std::vector<std::vector<Transition>> transitions;  // by state; at most one for each symbol
  std::vector<bool> accepting;                       // the task is done on the way into such a state
  std::uint32_t start = 0;                           // not accepting
};

struct Region {
  std::uint32_t symbol = 0;
  double volume = 1;
  std::vector<int> neighbours;
};

struct ExplorationProblem {
  SymbolAutomaton task;
  std::vector<Region> regions;
  std::function<std::optional<std::uint32_t>(const Configuration&)> region_of;
  std::function<bool(const Configuration&, const Configuration&)> is_free;  // one piece of motion
  Point low, high;                                                          // all positions lie between
  double step = 0.04;  // of propagation: its length, at most
  Robot robot;
  Configuration start;
};

// Whether some run of the automaton goes from region to neighbouring region to acceptance: where none does, no motion
// solves the task. OMPL must not be asked then: it ends by a segmentation fault.
bool has_run(const ExplorationProblem& problem);

// A line of configurations that ends where the task is done, joined by pieces of motion of the robot; empty when the
// time is over first. has_run(problem). Silences OMPL's messages for the whole process.
std::vector<Configuration> explore(const ExplorationProblem& problem, double seconds, std::uint32_t seed);

}  // namespace waymark::plan
