// Free space: the allowed positions of a robot, in the hallways of a map (workspace.hpp) or among polygons
// (terrain.hpp).
//
// Freedom along a piece of motion is proved and not sampled. Along a part of a piece, no point of a car moves farther
// than the car drives plus its reach times the turned angle. If the body in the middle of the part is farther from
// every obstacle than half of this length, the part is free; otherwise the part is halved. This is conservative
// advancement [Mir96] by bisection. A body nearer than 1e-4 to the border touches the border.
#pragma once
#include "libplan/motion/robot.hpp"

namespace waymark::plan {

class FreeSpace {
 public:
  FreeSpace() = default;
  FreeSpace(const FreeSpace&) = default;
  FreeSpace(FreeSpace&&) = default;
  FreeSpace& operator=(const FreeSpace&) = default;
  FreeSpace& operator=(FreeSpace&&) = default;
  virtual ~FreeSpace() = default;

  // Whether a disc of that radius fits all the way from a to b. Exact up to rounding; a point (radius 0) keeps off the
  // border too.
  virtual bool admits(Point a, Point b, double radius) const = 0;
  virtual bool contains(Point p) const = 0;
  // From the box to the border or an obstacle, at most `most`; a box that meets one has 0.
  virtual double clearance(const Box& box, double most) const = 0;
};

bool admits(const FreeSpace& space, const Configuration& c, const Robot& robot);  // does the body touch no wall there?
bool admits(const FreeSpace& space, const Piece& piece, const Robot& robot);      // all along it

}  // namespace waymark::plan
