// The interface to OMPL's geometric planners [SMK12]: short paths by sampling, for points and for cars.
//
// Informed RRT* [GSB14] or BIT* [GSB15] runs for a given number of iterations. OMPL seeds its generators from one
// sequence of the process. This sequence restarts before every search, so equal arguments give equal bytes. The
// informed subset is sampled by rejection, which serves both spaces and has the distribution of OMPL's direct method.
// The functions here silence OMPL's messages for the whole process.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "libplan/motion/piece.hpp"

namespace waymark::plan {

enum class Sampler : std::uint8_t { InformedRrtStar, BitStar };

struct SamplingBudget {                        // what may be spent
  Sampler sampler = Sampler::InformedRrtStar;  // which planner
  std::size_t iterations = 1'000;              // of RRT*: samples; of BIT*: edges taken from its queue, and batches
  std::uint32_t seed = 1;                      // of OMPL's generators
};

struct PathProblem {                          // a path of points
  Point low, high;                            // opposite corners of the rectangle
  std::function<bool(Point, Point)> is_free;  // may one move straight from one point to the other, and back?
  Point start;                                // where it begins
  std::vector<Point> goals;                   // where it may end
};
// The points of the path, start and goal included; empty when none was found. O(iterations²), calls of is_free
// O(iterations · log iterations).
std::vector<Point> sample_path(const PathProblem& problem, const SamplingBudget& budget);

using Line = std::vector<Configuration>;  // each leads to the next by an arc of at most an eighth of a circle

// The shortest way of a car that drives forwards and backwards [RS90], both ends included.
Line shortest_drive(const Configuration& from, const Configuration& to, double turning_radius);

struct DriveProblem {  // a path of a car
  Point low, high;     // the positions that are sampled
  double heading = 0,
         aside = 180;                        // the headings that are: this one, and up to so many degrees to both sides
  double turning_radius = 1;                 // the least
  std::function<bool(const Line&)> is_free;  // along a line that the car drives
  Configuration start;                       // where it begins
  std::vector<Configuration> goals;          // where it may end
};
Line sample_drive(const DriveProblem& problem, const SamplingBudget& budget);  // empty when none was found

}  // namespace waymark::plan
