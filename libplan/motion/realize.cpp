#include "libplan/motion/realize.hpp"

#include <cassert>

#include "libplan/motion/steer_car.hpp"
#include "libplan/motion/steer_disc.hpp"

namespace waymark::plan {

Realization realize(const Trajectory& route, const Workspace& workspace, const Sampling& sampling) {
  Realization outcome = std::holds_alternative<Disc>(sampling.robot) ? steer_disc(route, workspace, sampling)
                                                                     : steer_car(route, workspace, sampling);
  assert(!std::holds_alternative<Motion>(outcome) ||
         std::get<Trajectory>(route_of(std::get<Motion>(outcome), workspace)) == route);
  return outcome;
}

}  // namespace waymark::plan
