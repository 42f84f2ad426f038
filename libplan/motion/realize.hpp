// Route → motion: the last arrow of the corridor.
//
// Actions become pieces of motion: a turn is a turn in place, and every straight stretch of the route (FORWARD after
// FORWARD) is one leg. A leg is confined to the rectangle of the cells it passes, where no other label can be
// read: a path through it that does not go back has the word of the stretch. Where the straight line is free it is
// the shortest path; otherwise the leg is sampled (ompl_bridge.hpp), tightened, and its corners rounded. Furniture is
// driven round; a robot that ends a leg at a piece of furniture stops beside it.
// The heading stays that of the route while the robot moves: a disc moves sideways too (a car does not).
// Legs are planned one by one, each from where the last one ended: every leg is short, their sum need not be least.
#pragma once
#include <cstddef>
#include <cstdint>
#include <variant>

#include "libplan/motion/motion.hpp"

namespace waymark::plan {

struct Sampling {
  std::size_t iterations = 1'000;  // for each leg that is sampled; no clock, so equal seeds give equal bytes
  std::uint64_t seed = 1;
  double radius = 0.05;  // of the robot; 0: a point
};

struct Unreached {  // nothing proved: a leg for which no path was found
  PoseId from, to;
  std::size_t iterations = 0;  // spent on it
};
using Realization = std::variant<Motion, Unreached>;

// A motion whose route is this one, or the first leg for which the iterations did not suffice. Throws
// std::invalid_argument when a robot of that radius fits into no hallway, or not where the route starts.
Realization realize(const Trajectory& route, const Workspace& workspace, const Sampling& sampling = {});
inline Realization realize(const CertifiedRoute& route, const Workspace& workspace,
                           const Sampling& sampling = {}) {
  return realize(route.route(), workspace, sampling);
}

}  // namespace waymark::plan
