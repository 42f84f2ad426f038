#include "libplan/motion/piece.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::plan {
namespace {

constexpr double slip = 1e-7;      // off the arc, in units of the map: what rounding and printing may do
constexpr double straight = 1e-9;  // radians: with less turn an arc is its chord

double chord_share(double half_angle) {  // of the length of an arc: sin α / α
  return std::abs(half_angle) < 1e-4 ? 1 - half_angle * half_angle / 6 : std::sin(half_angle) / half_angle;
}

void keep_inner(double t, std::vector<double>& out) {
  if (t > 0 && t < 1) out.push_back(t);
}

}  // namespace

Point ahead_of(double heading) { return {std::sin(radians(heading)), -std::cos(radians(heading))}; }

double normalized(double heading) {
  const double rest = std::fmod(heading, full_turn);
  const double positive = rest < 0 ? rest + full_turn : rest;
  return positive < full_turn ? positive + 0.0 : 0;  // −1e-20 + 360 is 360
}

double turn_between(double from, double to) {
  const double turn = std::fmod(to - from + 2 * full_turn, full_turn);  // 0 … 360
  return turn > half_turn ? turn - full_turn : turn;
}

Piece Piece::gliding(const Configuration& from, const Configuration& to) {
  Piece piece(from, turn_between(from.heading, to.heading));
  piece.step_ = Point{to.x - from.x, to.y - from.y};
  return piece;
}

Piece Piece::driving(const Configuration& from, double way, double turn) {
  Piece piece(from, turn);
  piece.way_ = way;
  return piece;
}

// The chord of an arc points half way between the two headings.
std::optional<Piece> Piece::driving(const Configuration& from, const Configuration& to) {
  const double turn = turn_between(from.heading, to.heading);
  const Point middle = ahead_of(from.heading + turn / 2), chord{to.x - from.x, to.y - from.y};
  const double along = chord.x * middle.x + chord.y * middle.y;
  const double aside = chord.x * middle.y - chord.y * middle.x;
  if (!(std::abs(aside) <= slip)) return std::nullopt;
  return driving(from, along / chord_share(radians(turn) / 2), turn);
}

Configuration Piece::at(double t) const {
  const double heading = normalized(from_.heading + t * turn_);
  if (step_) return {from_.x + t * step_->x, from_.y + t * step_->y, heading};
  const double chord = t * way_ * chord_share(radians(t * turn_) / 2);
  const Point towards = ahead_of(from_.heading + t * turn_ / 2);
  return {from_.x + chord * towards.x, from_.y + chord * towards.y, heading};
}

double Piece::length() const { return step_ ? std::hypot(step_->x, step_->y) : std::abs(way_); }

void Piece::passes_line(Point normal, double offset, std::vector<double>& out) const {
  const double here = normal.x * from_.x + normal.y * from_.y;
  const double angle = radians(turn_), start = radians(from_.heading);
  if (step_ || std::abs(angle) < straight) {
    const Configuration end = at(1);
    const double rate = normal.x * (end.x - from_.x) + normal.y * (end.y - from_.y);
    if (rate != 0) keep_inner((offset - here) / rate, out);
    return;
  }
  // On the arc n·p = n·c − ρ |n| cos(h − ψ), with ρ = way / angle, c the centre of the circle, h the heading and ψ the
  // direction of n as an angle from the x-axis.
  const double radius = way_ / angle, size = std::hypot(normal.x, normal.y);
  const double centre = here + radius * (normal.x * std::cos(start) + normal.y * std::sin(start));
  const double cosine = (centre - offset) / (radius * size);
  if (!(std::abs(cosine) <= 1)) return;
  const double direction = std::atan2(normal.y, normal.x), away = std::acos(cosine);
  for (const double heading : {direction + away, direction - away})
    for (int k = -2; k <= 2; ++k) keep_inner((heading - start + k * radians(full_turn)) / angle, out);
}

void Piece::passes_heading(double heading, double period, std::vector<double>& out) const {
  if (turn_ == 0) return;
  const double end = from_.heading + turn_;
  const double low = std::ceil((std::min(from_.heading, end) - heading) / period);
  const double high = std::floor((std::max(from_.heading, end) - heading) / period);
  for (double k = low; k <= high; ++k) keep_inner((k * period + heading - from_.heading) / turn_, out);
}

}  // namespace waymark::plan
