// Robots: their shape, and how they get from one configuration to another.
//
// A disc (a point when its radius is 0) translates and turns on the spot. A car is a rectangle. Its position is the
// middle of its rear axle, a fifth of its length before its back. This point follows arcs of at least its turning
// radius, forwards and backwards [RS90]. Lengths are in units of the map: with 3 m between two places, the default car
// is 42 cm long and 24 cm wide, and turns on a circle of radius 30 cm.
#pragma once
#include <optional>
#include <variant>

#include "libplan/motion/piece.hpp"

namespace waymark::plan {

struct Disc {
  double radius = 0.05;  // 0: a point
  friend bool operator==(const Disc&, const Disc&) = default;
};
struct Car {                                                 // a rectangle that drives
  double length = 0.14, width = 0.08, turning_radius = 0.1;  // the turning radius of its rear axle
  friend bool operator==(const Car&, const Car&) = default;
};
using Robot = std::variant<Disc, Car>;  // of one of these shapes

bool is_possible(const Robot& robot);              // no negative radius; lengths of a car are positive; all are finite
Box body(const Car& car, const Configuration& c);  // the corners of the car there
double reach(const Car& car);                      // from the position to the farthest corner of the body

// How the robot gets from one to the other; nullopt where it cannot in one piece: half a turn is meant either way, and
// a car neither slips sideways, nor turns in place, nor tighter than its turning radius.
std::optional<Piece> piece_between(const Configuration& from, const Configuration& to, const Robot& robot);

}  // namespace waymark::plan
