// Motions: what the robot does in continuous space, the route that can be read off it, and the proof that this route
// does what was asked.
//
// A motion is a line of configurations. Between two of them the robot moves straight and turns the short way, both at
// constant rates. Its route is read off the geometry alone: FORWARD happens where the centre of the robot enters the
// cell of another node, a turn where its heading comes nearer to the next quarter than to the last one; turning so
// far between two places, or entering a place other than the one ahead, is no step of any route. Leaving a cell and
// coming back to it without having entered another is no event.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libplan/motion/workspace.hpp"
#include "libplan/solve/certify.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::plan {

struct Configuration {
  double x = 0, y = 0;
  double heading = 0;  // degrees clockwise from north, 0 ≤ heading < 360
  friend bool operator==(const Configuration&, const Configuration&) = default;
};
inline Point position(const Configuration& c) { return {c.x, c.y}; }
// Degrees to turn from one heading to the other the short way, clockwise positive: in (−180, 180].
double turn_between(double from, double to);

struct Motion {
  std::vector<Configuration> configurations;
  double radius = 0;  // of the robot, a disc; 0: a point
  friend bool operator==(const Motion&, const Motion&) = default;
};
double length(const Motion& motion);  // of the line that the centre draws, in units of the map

struct NoRoute {         // the motion is no motion along any route
  std::size_t step = 0;  // the fault lies on the way to this configuration
  std::string reason;
};
// The route of the motion: poses and actions. O(|motion|) cells and walls.
std::variant<Trajectory, NoRoute> route_of(const Motion& motion, const Workspace& workspace);

// A motion that was checked: it keeps off walls and furniture, and the word of its route ⊨ φ.
// The only way to get one is certify; whatever prints or draws a motion takes this type.
class CertifiedMotion {
 public:
  const Motion& motion() const { return motion_; }
  const CertifiedRoute& route() const { return route_; }  // read off the motion, not the one it was made from

 private:
  friend CertifiedMotion certify(Motion motion, const Workspace& workspace, ltl::Formula f);
  CertifiedMotion(Motion motion, CertifiedRoute route)
      : motion_(std::move(motion)), route_(std::move(route)) {}
  Motion motion_;
  CertifiedRoute route_;
};

// Throws std::logic_error (we are wrong) naming the configuration or the formula when the check fails.
CertifiedMotion certify(Motion motion, const Workspace& workspace, ltl::Formula f);

}  // namespace waymark::plan
