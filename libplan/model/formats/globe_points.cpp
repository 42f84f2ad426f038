#include "libplan/model/formats/globe_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace waymark::plan {
namespace {

constexpr double mean_radius = 6'371'008.8;  // metres, of WGS 84, as in road_network.cpp

double in_radians(std::int32_t angle) { return angle * (std::numbers::pi / (180.0 * FixedPoint::degree)); }

GlobeRay ray_to(const FixedPoint& p) {
  const double lambda = in_radians(p.longitude), phi = in_radians(p.latitude);
  return {std::cos(phi) * std::cos(lambda), std::cos(phi) * std::sin(lambda), std::sin(phi)};
}
double chord_of(const GlobeRay& a, const GlobeRay& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

// The angle from a point to the half of a meridian.
double to_meridian(const FixedPoint& p, double longitude) {
  const double away = std::fabs(std::remainder(in_radians(p.longitude) - longitude, 2 * std::numbers::pi));
  if (away >= std::numbers::pi / 2) return std::numbers::pi / 2 - std::fabs(in_radians(p.latitude));
  return std::asin(std::cos(in_radians(p.latitude)) * std::sin(away));
}

}  // namespace

double metres(const FixedPoint& a, const FixedPoint& b) {
  return 2 * mean_radius * std::asin(std::min(1.0, chord_of(ray_to(a), ray_to(b)) / 2));
}

struct GlobePoints::Nearest {
  FixedPoint to;
  GlobeRay at;
  double chord = 3;  // more than any
  std::uint32_t number = UINT32_MAX;
  double angle() const { return 2 * std::asin(std::min(1.0, chord / 2)) * (1 + 1e-12) + 1e-14; }  // rounded up
};

GlobePoints::GlobePoints(const std::vector<FixedPoint>& points) : points_(points), order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  split(0, order_.size(), true);
}

void GlobePoints::split(std::size_t first, std::size_t last, bool by_longitude) {
  if (last - first < 2) return;
  const auto begin = order_.begin();
  const std::size_t middle = first + (last - first) / 2;
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                   begin + static_cast<std::ptrdiff_t>(last), [&](std::uint32_t a, std::uint32_t b) {
                     return by_longitude ? points_[a].longitude < points_[b].longitude
                                         : points_[a].latitude < points_[b].latitude;
                   });
  split(first, middle, !by_longitude);
  split(middle + 1, last, !by_longitude);
}

std::uint32_t GlobePoints::nearest(const FixedPoint& to) const {
  Nearest best{to, ray_to(to)};
  look(0, order_.size(), true, best);
  return best.number;
}

// The other side of a split is looked at where a point there could be as near. West of a longitude, that is also what
// lies behind the meridian of 180 degrees.
void GlobePoints::look(std::size_t first, std::size_t last, bool by_longitude, Nearest& best) const {
  if (first == last) return;
  const std::size_t middle = first + (last - first) / 2;
  const FixedPoint& p = points_[order_[middle]];
  const double length = chord_of(ray_to(p), best.at);
  if (length < best.chord || (length == best.chord && order_[middle] < best.number)) {
    best.chord = length;
    best.number = order_[middle];
  }
  const bool low = by_longitude ? best.to.longitude < p.longitude : best.to.latitude < p.latitude;
  if (low)
    look(first, middle, !by_longitude, best);
  else
    look(middle + 1, last, !by_longitude, best);
  const double away =
      by_longitude ? std::min(to_meridian(best.to, in_radians(p.longitude)), to_meridian(best.to, std::numbers::pi))
                   : std::fabs(in_radians(best.to.latitude) - in_radians(p.latitude));
  if (away > best.angle()) return;
  if (low)
    look(middle + 1, last, !by_longitude, best);
  else
    look(first, middle, !by_longitude, best);
}

}  // namespace waymark::plan
