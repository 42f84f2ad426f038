// The one door to OMPL [SMK12]: a short way from a point to one of several others, found by sampling.
//
// Informed RRT* [GSB14] in a rectangle, for a set number of iterations. OMPL seeds its generators from one
// process-wide sequence; here every generator that is used gets a seed of its own, so that equal arguments give equal
// bytes whatever the process did before. For that the informed subset is sampled by rejection, which takes a little
// longer than OMPL's direct way and draws from the same distribution.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "libplan/motion/workspace.hpp"

namespace waymark::plan {

struct SamplingProblem {
  Point low, high;                            // opposite corners of the rectangle
  std::function<bool(Point, Point)> is_free;  // may one move straight from one point to the other, and back?
  Point start;
  std::vector<Point> goals;
};

// The points of the path, start and goal included; empty when none was found. O(iterations²), calls of is_free
// O(iterations · log iterations). Silences OMPL's messages for the whole process.
std::vector<Point> sample_path(const SamplingProblem& problem, std::size_t iterations, std::uint32_t seed);

}  // namespace waymark::plan
