// Route → motion of a disc: turns on the spot, and straight stretches around obstacles.
//
// Every straight stretch of the route (FORWARD after FORWARD) is one leg, confined to the rectangle of its cells. No
// other label is read there, so a path through the rectangle that does not go back has the word of the stretch. A free
// straight line is the shortest path. Otherwise the leg is sampled (ompl_bridge.hpp), shortened, and its corners are
// rounded. A leg that ends at furniture ends beside the furniture. The heading stays that of the route during the leg,
// because a disc can move sideways. Each leg starts where the last one ended. Each leg is short, and their sum need not
// be least.
#pragma once
#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

// As realize says; the robot must be a disc.
Realization steer_disc(const Trajectory& route, const Workspace& workspace, const Sampling& sampling);

// Paths of straight lines. From every point straight on to the farthest one that can be reached; corners cut a quarter
// into both of their sides [Cha74], where the cut is free, three times over.
std::vector<Point> tightened(const std::vector<Point>& path, const std::function<bool(Point, Point)>& is_free);
std::vector<Point> rounded(std::vector<Point> path, const std::function<bool(Point, Point)>& is_free);

}  // namespace waymark::plan
