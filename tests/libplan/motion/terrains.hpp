// Terrains for the tests of this area.
#pragma once
#include "libplan/motion/terrain.hpp"

namespace waymark::plan {

inline Polygon rectangle(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

// Two rooms of a house 9 by 4 with a door between them, through a wall at x = 4.4 … 4.6; a wet strip along the bottom.
inline Terrain two_rooms() {
  return Terrain("two rooms", rectangle(0, 0, 9, 4), {rectangle(4.4, 0, 4.6, 1.4), rectangle(4.4, 2.6, 4.6, 4)},
                 {{"left", rectangle(0, 0, 3, 4)}, {"right", rectangle(6, 0, 9, 4)}, {"wet", rectangle(1, 3, 8, 3.8)}});
}

// Slanted edges that cross: two overlapping diamonds and a triangle in the way.
inline Terrain diamonds() {
  return Terrain(
      "diamonds", {{0, 0}, {6, 0.5}, {6.5, 5}, {-0.5, 5.5}}, {{{2.8, 2}, {3.6, 2.4}, {3, 3.1}}},
      {{"a", {{2, 0.8}, {3.7, 2.5}, {2, 4.2}, {0.3, 2.5}}}, {"b", {{4, 0.8}, {5.7, 2.5}, {4, 4.2}, {2.3, 2.5}}}});
}

}  // namespace waymark::plan
