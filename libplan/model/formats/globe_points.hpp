// Many points on the globe, by which one asks for the nearest and for those in a box: a k-d tree without pointers.
//
// A tree is an order of the points: the middle of a range splits it, by longitude and latitude in turn. It takes four
// bytes a point; the points stay where they are.
#pragma once
#include <cstdint>
#include <vector>

namespace waymark::plan {

struct FixedPoint {                                   // WGS 84
  static constexpr std::int32_t degree = 10'000'000;  // the unit of OpenStreetMap
  std::int32_t longitude = 0;                         // within ±180 degrees, eastwards
  std::int32_t latitude = 0;                          // within ±90 degrees, northwards
  friend bool operator==(const FixedPoint&, const FixedPoint&) = default;
};
double metres(const FixedPoint& a, const FixedPoint& b);  // on the sphere of the mean radius

struct GlobeRay {  // from the centre of the earth, of length 1
  double x, y, z;  // to the meridian of Greenwich, to 90 degrees east, to the north
};

class GlobePoints {
 public:
  explicit GlobePoints(const std::vector<FixedPoint>& points);  // kept by reference. O(points · log points)

  // The number of a nearest point, of several the least. There must be a point.
  std::uint32_t nearest(const FixedPoint& to) const;
  // visit(number) of every point in the box, borders included; a box does not cross the meridian of 180 degrees.
  template <class Visit>
  void for_each_in(const FixedPoint& low, const FixedPoint& high, const Visit& visit) const {
    visit_box(0, order_.size(), true, low, high, visit);
  }

 private:
  struct Nearest;
  void split(std::size_t first, std::size_t last, bool by_longitude);
  void look(std::size_t first, std::size_t last, bool by_longitude, Nearest& best) const;
  template <class Visit>
  void visit_box(std::size_t first, std::size_t last, bool by_longitude, const FixedPoint& low, const FixedPoint& high,
                 const Visit& visit) const {
    if (first == last) return;
    const std::size_t middle = first + (last - first) / 2;
    const FixedPoint& p = points_[order_[middle]];
    if (low.longitude <= p.longitude && p.longitude <= high.longitude && low.latitude <= p.latitude &&
        p.latitude <= high.latitude)
      visit(order_[middle]);
    const std::int32_t here = by_longitude ? p.longitude : p.latitude;
    if ((by_longitude ? low.longitude : low.latitude) <= here)
      visit_box(first, middle, !by_longitude, low, high, visit);
    if ((by_longitude ? high.longitude : high.latitude) >= here)
      visit_box(middle + 1, last, !by_longitude, low, high, visit);
  }

  const std::vector<FixedPoint>& points_;
  std::vector<std::uint32_t> order_;
};

}  // namespace waymark::plan
