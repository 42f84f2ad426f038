// Route → motion, the last stage.
//
// The method depends on the robot: steer_disc.hpp for a disc, steer_car.hpp for a car. Both plan leg by leg inside
// cells with one label, and return a motion whose route, by route_of, is the given one.
#pragma once
#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

// A motion whose route is this one, or the first leg for which the iterations did not suffice. Throws
// std::invalid_argument when the robot fits into no hallway, or not where the route starts.
Realization realize(const Trajectory& route, const Workspace& workspace, const Sampling& sampling = {});
inline Realization realize(const CertifiedRoute& route, const Workspace& workspace, const Sampling& sampling = {}) {
  return realize(route.route(), workspace, sampling);
}

}  // namespace waymark::plan
