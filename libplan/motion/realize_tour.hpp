// Formula → motion through a terrain, by two methods.
//
// By a route: the shortest run through the cells comes first (tour.hpp). Every stretch of the run with one letter is a
// leg, which ends a little behind the passage to the next letter. A leg is a straight line, or the shortest curve of a
// car, where this is free and reads no other letter. Otherwise the leg is sampled (ompl_bridge.hpp) where its two
// letters are read, and shortened. When a leg is not found, its last passage is blocked and the search restarts.
// Passages too narrow for the body are blocked at the start.
// By exploration: OMPL's LTLPlanner on the cells (ltl_bridge.hpp); a symbol is a letter. A disc keeps its start
// heading.
#pragma once
#include "libplan/motion/explore.hpp"
#include "libplan/motion/sampling.hpp"
#include "libplan/motion/tour.hpp"

namespace waymark::plan {

struct NotFound {            // nothing proved
  std::size_t attempts = 0;  // runs through the cells
};
using TourOutcome = std::variant<Motion, NoRun, NotFound>;  // a motion, a proof that there is none, or neither

// Both throw std::invalid_argument when the robot does not fit where it starts. The automaton must be of the vocabulary
// of the terrain.
TourOutcome realize(const automata::Dfa& dfa, const Terrain& terrain, const Configuration& start,
                    const Sampling& sampling);
Explored explore(const automata::Dfa& dfa, const Terrain& terrain, const Configuration& start, const Exploration& how);

}  // namespace waymark::plan
