#include "libplan/motion/robot.hpp"

#include <cmath>

namespace waymark::plan {
namespace {

constexpr double rear_share = 0.2;  // of the length of a car, behind its rear axle
constexpr double rounding = 1e-6;   // relative, of the turning radius; a tenth of it absolute, of the length of arcs

bool is_length(double value) { return std::isfinite(value) && value > 0; }

}  // namespace

bool is_possible(const Robot& robot) {
  if (const auto* disc = std::get_if<Disc>(&robot)) return std::isfinite(disc->radius) && disc->radius >= 0;
  const auto& car = std::get<Car>(robot);
  return is_length(car.length) && is_length(car.width) && is_length(car.turning_radius);
}

Box body(const Car& car, const Configuration& c) {
  const Point ahead = ahead_of(c.heading), right{-ahead.y, ahead.x};
  const auto at = [&](double forward, double sideways) {
    return Point{c.x + forward * ahead.x + sideways * right.x, c.y + forward * ahead.y + sideways * right.y};
  };
  const double front = (1 - rear_share) * car.length, back = -rear_share * car.length, side = car.width / 2;
  return {at(front, -side), at(front, side), at(back, side), at(back, -side)};
}

double reach(const Car& car) { return std::hypot((1 - rear_share) * car.length, car.width / 2); }

std::optional<Piece> piece_between(const Configuration& from, const Configuration& to, const Robot& robot) {
  if (std::abs(turn_between(from.heading, to.heading)) == 180) return std::nullopt;
  if (std::holds_alternative<Disc>(robot)) return Piece::gliding(from, to);
  const auto piece = Piece::driving(from, to);
  const double tightest = std::get<Car>(robot).turning_radius * (1 - rounding);
  if (!piece || piece->length() + rounding / 10 < tightest * std::abs(radians(piece->turn()))) return std::nullopt;
  return piece;
}

}  // namespace waymark::plan
