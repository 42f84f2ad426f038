// A piece of a motion: the movement of a robot from one configuration to the next.
//
// There are two kinds. A disc translates straight and rotates by the smaller angle, both at constant rates. A car
// follows a circular arc, or a straight line, to which its heading is always tangent, forwards or backwards. Both are
// functions of t in [0, 1]. The instants at which a piece crosses a line or a heading are solved for and not sampled.
#pragma once
#include <optional>
#include <vector>

#include "libplan/motion/geometry.hpp"

namespace waymark::plan {

struct Configuration {  // where a robot stands
  double x = 0, y = 0;  // of its centre
  double heading = 0;   // degrees clockwise from north, 0 ≤ heading < 360
  friend bool operator==(const Configuration&, const Configuration&) = default;
};
inline Point position(const Configuration& c) { return {c.x, c.y}; }                           // without the heading
Point ahead_of(double heading);                                                                // the unit vector
double normalized(double heading);                                                             // into [0, 360)
constexpr double quarter_turn = 90, half_turn = 180, full_turn = 360;                          // degrees
constexpr double radians(double degrees) { return degrees * (3.14159265358979323846 / 180); }  // of an angle

// Degrees to turn from one heading to the other the short way, clockwise positive: in (−180, 180].
double turn_between(double from, double to);

class Piece {
 public:
  static Piece gliding(const Configuration& from, const Configuration& to);  // of a disc
  // `way`: how far, negative backwards. The heading changes by `turn` degrees meanwhile, clockwise positive.
  static Piece driving(const Configuration& from, double way, double turn);
  // The arc that leads there turning the short way; nullopt where none does: the car would slip sideways by more than
  // 1e-7. How tight the arc is, is not looked at: turning on the spot is an arc of length 0.
  static std::optional<Piece> driving(const Configuration& from, const Configuration& to);

  Configuration at(double t) const;      // t from 0 (from) to 1 (to)
  double length() const;                 // of the line that the centre draws
  double turn() const { return turn_; }  // degrees, clockwise positive
  double way() const { return way_; }    // of a driving piece: its length, negative backwards

  // The parameters in (0, 1) at which the centre passes the line normal · p = offset, appended. Parameters at which it
  // only touches the line may be among them.
  void passes_line(Point normal, double offset, std::vector<double>& out) const;
  // … at which the heading passes heading + k · period for some integer k.
  void passes_heading(double heading, double period, std::vector<double>& out) const;

 private:
  Piece(const Configuration& from, double turn) : from_(from), turn_(turn) {}
  Configuration from_;
  double turn_;
  double way_ = 0;             // driving
  std::optional<Point> step_;  // gliding: to the other end
};

}  // namespace waymark::plan
