// Route → motion of a car: a lattice of places to be at, joined by the shortest drives.
//
// A leg is one turn, or one straight stretch up to the next turn or piece of furniture. After each leg the car may be at any of a few configurations in the cell
// that the leg ends in, headed as the route says; a leg joins two of them by the shortest drive forwards and backwards
// [RS90], taken only where it keeps off everything and reads as exactly the actions of the leg. The cheapest chain of
// drives through all legs is found layer by layer, so that a corner is approached the way it is best turned. Where no
// drive joins two layers the leg is sampled (ompl_bridge.hpp) from the cheapest configurations that were reached.
#pragma once
#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

// As realize says; the robot must be a car.
Realization drive(const Trajectory& route, const Workspace& workspace, const Sampling& sampling);

}  // namespace waymark::plan
