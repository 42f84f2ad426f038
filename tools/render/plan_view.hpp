// The plan view of a map: where its places lie on the page, and which corners around them are taken.
//
// One unit of the map is `cell` pixels; a hallway is a strip of width `strip`. Labels that belong to a place stand at
// one of the four corners outside its tile, where no hallway runs; whoever writes there says so first.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "libplan/world/map.hpp"
#include "tools/render/svg.hpp"

namespace waymark::render {

enum class Corner : std::uint8_t { NorthWest, NorthEast, SouthEast, SouthWest };

// Unit vector of a heading on the page: 0 is up, 90 right.
Point direction(int heading);

class PlanView {
 public:
  static constexpr double cell = 112, strip = 50, margin = 64;

  explicit PlanView(const plan::Map& map);
  const plan::Map& map() const { return *map_; }
  double width() const { return width_; }
  double height() const { return height_; }
  Point centre(std::uint32_t node) const;
  Point centre(double x, double y) const;                // in map coordinates
  Point corner(std::uint32_t node, Corner where) const;  // the middle of a label there
  int min_x() const { return min_x_; }
  int max_x() const { return max_x_; }
  int min_y() const { return min_y_; }
  int max_y() const { return max_y_; }

  void take(std::uint32_t node, Corner where);
  Corner take_free(std::uint32_t node);  // the first free corner, north-west if none is

 private:
  const plan::Map* map_;
  int min_x_, max_x_, min_y_, max_y_;
  double width_, height_;
  std::vector<std::array<bool, 4>> taken_;
};

}  // namespace waymark::render
