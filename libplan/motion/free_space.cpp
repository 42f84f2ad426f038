#include "libplan/motion/free_space.hpp"

#include <cmath>

namespace waymark::plan {
namespace {

constexpr double touching = 1e-4;

struct Sweep {
  const FreeSpace& space;
  const Piece& piece;
  const Car& car;
  double path;  // no point of the body moves farther along the whole piece

  bool is_free(double low, double high) const {
    const double middle = (low + high) / 2, needed = path * (high - low) / 2 + touching;
    const double gap = space.clearance(body(car, piece.at(middle)), needed);
    if (gap >= needed) return true;
    if (gap < touching || needed < 2 * touching) return false;
    return is_free(low, middle) && is_free(middle, high);
  }
};

}  // namespace

bool admits(const FreeSpace& space, const Configuration& c, const Robot& robot) {
  if (const auto* disc = std::get_if<Disc>(&robot)) return space.admits(position(c), position(c), disc->radius);
  return space.contains(position(c)) && space.clearance(body(std::get<Car>(robot), c), touching) >= touching;
}

bool admits(const FreeSpace& space, const Piece& piece, const Robot& robot) {
  const Configuration from = piece.at(0), to = piece.at(1);
  if (const auto* disc = std::get_if<Disc>(&robot)) return space.admits(position(from), position(to), disc->radius);
  const auto& car = std::get<Car>(robot);
  const double path = piece.length() + reach(car) * std::abs(radians(piece.turn()));
  return space.contains(position(from)) && Sweep{space, piece, car, path}.is_free(0, 1);
}

}  // namespace waymark::plan
