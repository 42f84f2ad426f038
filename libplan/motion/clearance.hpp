// Clearance of a body from the regions that a task avoids.
//
// The letter of a tour has the regions that contain the centre of the robot. In a terrain whose avoided regions are
// widened by the reach of the body, a centre outside of a region means a body outside of it. Regions that a task wants
// to be reached stay as they are: the centre reaches them. A widened region is the polygon with mitred corners around
// all points within the reach, computed by Boost.Geometry.
#pragma once
#include <string>
#include <vector>

#include "libltl/formula.hpp"
#include "libplan/motion/robot.hpp"
#include "libplan/motion/terrain.hpp"

namespace waymark::plan {

// From the position of the robot to the farthest point of its body.
double reach(const Robot& robot);

// The propositions that occur under negation alone, in negation normal form; a formula holds on more words the fewer
// letters have them. Throws std::invalid_argument naming a proposition that is both avoided and wanted.
std::vector<ltl::Proposition> avoided(ltl::Formula f);

// All regions of these names contain every point within `distance` of what they contained. O(corners).
Terrain widened(const Terrain& terrain, const std::vector<std::string>& names, double distance);

}  // namespace waymark::plan
