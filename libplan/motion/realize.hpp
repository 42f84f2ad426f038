// Route → motion: the last arrow of the corridor.
//
// How it is made depends on the robot: a disc glides and turns in place (steer_disc.hpp), a car drives (steer_car.hpp). Both plan
// leg by leg inside cells where no other label can be read, and both answer with what route_of reads as the route.
#pragma once
#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

// A motion whose route is this one, or the first leg for which the iterations did not suffice. Throws
// std::invalid_argument when the robot fits into no hallway, or not where the route starts.
Realization realize(const Trajectory& route, const Workspace& workspace, const Sampling& sampling = {});
inline Realization realize(const CertifiedRoute& route, const Workspace& workspace,
                           const Sampling& sampling = {}) {
  return realize(route.route(), workspace, sampling);
}

}  // namespace waymark::plan
