// Formula → motion through a terrain, in both ways.
//
// By a route first: the shortest run through the cells (tour.hpp); every stretch of it on which one letter is read is a
// leg, which ends a little behind the passage to the next letter. A leg goes straight, or by the shortest drive of a car,
// where that is free and reads no other letter; otherwise it is sampled (ompl_bridge.hpp) where its two letters are
// read, and shortened. Where a leg is not found its last passage is blocked and the search begins anew.
// By exploration: OMPL's LTLPlanner on the cells (ltl_bridge.hpp); a symbol is a letter.
// A disc keeps the heading that it starts with.
#pragma once
#include "libplan/motion/explore.hpp"
#include "libplan/motion/sampling.hpp"
#include "libplan/motion/tour.hpp"

namespace waymark::plan {

struct NotFound {  // nothing proved
  std::size_t attempts = 0;
};
using TourOutcome = std::variant<Motion, NoRun, NotFound>;

// Both throw std::invalid_argument when the robot does not fit where it starts. The automaton must be of the vocabulary
// of the terrain.
TourOutcome realize(const automata::Dfa& dfa, const Terrain& terrain, const Configuration& start,
                    const Sampling& sampling);
Explored explore(const automata::Dfa& dfa, const Terrain& terrain, const Configuration& start,
                 const Exploration& how);

}  // namespace waymark::plan
