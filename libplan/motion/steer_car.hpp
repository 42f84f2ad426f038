// Route → motion of a car: a lattice of configurations, joined by the shortest curves.
//
// A leg is one turn, or one straight stretch up to the next turn or piece of furniture. A leg ends at one of a few
// configurations in its last cell, with the heading of the route. A leg joins two of them by the shortest curve
// forwards and backwards [RS90], if this curve touches nothing and reads as exactly the actions of the leg. The
// cheapest chain of curves is found layer by layer, so the approach to a corner suits the turn. Where no curve joins
// two layers, the leg is sampled (ompl_bridge.hpp) from the cheapest configurations that were reached.
#pragma once
#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

// As realize says; the robot must be a car.
Realization steer_car(const Trajectory& route, const Workspace& workspace, const Sampling& sampling);

}  // namespace waymark::plan
