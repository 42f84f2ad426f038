// A town of our own for the tests: eight landmarks, two of them hardly apart.
#pragma once
#include <string_view>

#include "libparser/domain/streets/street_corpus.hpp"

namespace waymark::streets {

//   church   (0,0) — bakery (1,0) — old mill (2,0) — museum (3,0)
//     |                 |                |
//   café niño (0,1) — well (1,1) — new mill (2,1) — wall (2.05,1)
// Ways join neighbours along rows and columns, the mills and the wall; lengths are distances.
inline StreetMap town() {
  return parse_street_map(R"({"name": "town", "nodes": [
    {"id": 0, "name": "Church", "u": 0, "v": 0}, {"id": 1, "name": "Bakery", "u": 1, "v": 0},
    {"id": 2, "name": "Old Mill", "u": 2, "v": 0}, {"id": 3, "name": "Museum", "u": 3, "v": 0},
    {"id": 5, "name": "Café Niño", "u": 0, "v": 1}, {"id": 6, "name": "Well", "u": 1, "v": 1},
    {"id": 7, "name": "New Mill", "u": 2, "v": 1}, {"id": 8, "name": "Wall", "u": 2.05, "v": 1}],
   "edges": [{"a": 0, "b": 1, "length": 1}, {"a": 1, "b": 2, "length": 1}, {"a": 2, "b": 3, "length": 1},
    {"a": 0, "b": 5, "length": 1}, {"a": 1, "b": 6, "length": 1}, {"a": 2, "b": 7, "length": 1},
    {"a": 5, "b": 6, "length": 1}, {"a": 6, "b": 7, "length": 1}, {"a": 7, "b": 8, "length": 0.05}]})");
}

enum : LandmarkIndex { church, bakery, old_mill, museum, cafe, well, new_mill, wall };

}  // namespace waymark::streets
