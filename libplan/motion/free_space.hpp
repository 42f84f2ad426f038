// Free space: where a robot may be. The hallways of a map (workspace.hpp) and polygons (polygons.hpp) are two of it.
//
// Whether a body keeps off the border all along a piece of motion is proved, not sampled: no point of a car gets farther
// along a part of a piece than the car drives there plus its reach times the angle that it turns. Where the body in
// the middle of the part is farther from everything than half of that, the whole part is free; otherwise the part is
// halved. This is conservative advancement [Mir96] by bisection. A body nearer than 1e-4 to the border touches it.
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

bool admits(const FreeSpace& space, const Configuration& c, const Robot& robot);
bool admits(const FreeSpace& space, const Piece& piece, const Robot& robot);  // all along it

}  // namespace waymark::plan
