// Route → motion of a disc: turns in place, straight stretches driven round what stands in the way.
//
// Every straight stretch of the route (FORWARD after FORWARD) is one leg, confined to the rectangle of the cells it
// passes, where no other label can be read: a path through it that does not go back has the word of the stretch. Where
// the straight line is free it is the shortest path; otherwise the leg is sampled (ompl_bridge.hpp), tightened, and its
// corners rounded. A robot that ends a leg at a piece of furniture stops beside it. The heading stays that of the
// route while the robot moves: a disc moves sideways too.
// Legs are planned one by one, each from where the last one ended: every leg is short, their sum need not be least.
#pragma once
#include "libplan/motion/sampling.hpp"

namespace waymark::plan {

// As realize says; the robot must be a disc.
Realization glide(const Trajectory& route, const Workspace& workspace, const Sampling& sampling);

// Paths of straight lines. From every point straight on to the farthest one that can be reached; corners cut a quarter
// into both of their sides [Cha74], where the cut is free, three times over.
std::vector<Point> tightened(const std::vector<Point>& path,
                             const std::function<bool(Point, Point)>& is_free);
std::vector<Point> rounded(std::vector<Point> path, const std::function<bool(Point, Point)>& is_free);

}  // namespace waymark::plan
