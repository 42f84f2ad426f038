// Motions: the movement of a robot in continuous space, the route of a motion, and the certificate of this route.
//
// A motion is a sequence of configurations, joined by pieces (piece.hpp). Its route follows from the geometry alone.
// FORWARD happens where the centre of the robot enters the cell of another node. A turn happens where the heading
// becomes nearer to the next quarter than to the last one. A turn between two places, or entering a place other than
// the one ahead, is no step of any route. Leaving a cell and returning without entering another one is no event. A car
// cannot turn on the spot: its turn happens where its heading passes the diagonal, inside the cell. A car may back into
// a hallway during a turn, but not into a place.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libplan/certify.hpp"
#include "libplan/motion/workspace.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::plan {

struct Motion {
  std::vector<Configuration> configurations;  // at least one
  Robot robot;                                // whose body moves
  friend bool operator==(const Motion&, const Motion&) = default;
};
double length(const Motion& motion);            // of the line that the centre draws, in units of the map
int quarter_of(double heading);                 // the nearest one, 0 … 3; 0 is north
bool is_configuration(const Configuration& c);  // finite, 0 ≤ heading < 360
// The parts of the motion, one configuration less than it has: at each, a piece of less than half a turn. Throws
// std::invalid_argument where the robot has none (piece_between).
std::vector<Piece> pieces_of(const Motion& motion);

struct NoRoute {         // the motion is no motion along any route
  std::size_t step = 0;  // the fault lies on the way to this configuration
  std::string reason;    // what is wrong there
};
struct TimedRoute {  // a route and when it happens
  Trajectory route;  // of the motion
  // By action: when it happens. Between the configurations i and i + 1 the time runs from i to i + 1.
  std::vector<double> times;
};
// The route of the motion: poses and actions. O(|motion|) cells and walls.
std::variant<TimedRoute, NoRoute> timed_route_of(const Motion& motion, const Workspace& workspace);
std::variant<Trajectory, NoRoute> route_of(const Motion& motion, const Workspace& workspace);

// A motion that was checked: it keeps off walls and furniture, and the word of its route ⊨ φ.
// The only way to get one is certify; whatever prints or draws a motion takes this type.
class CertifiedMotion {
 public:
  const Motion& motion() const { return motion_; }             // as it was checked
  const CertifiedRoute& route() const { return route_; }       // read off the motion, not the one it was made from
  const std::vector<double>& times() const { return times_; }  // of the actions, as in TimedRoute

 private:
  friend CertifiedMotion certify(Motion motion, const Workspace& workspace, ltl::Formula f);
  CertifiedMotion(Motion motion, CertifiedRoute route, std::vector<double> times)
      : motion_(std::move(motion)), route_(std::move(route)), times_(std::move(times)) {}
  Motion motion_;
  CertifiedRoute route_;
  std::vector<double> times_;
};

// Throws std::logic_error (we are wrong) naming the configuration or the formula when the check fails.
CertifiedMotion certify(Motion motion, const Workspace& workspace, ltl::Formula f);

}  // namespace waymark::plan
