// Random grid worlds to plan on: rooms, mazes, scattered hazards, bridges over hazards, one-way streets.
//
// Drawn from a seed, the same on every machine. Landmarks a, b, … are put only where a search from the start arrives
// when nothing slips, past no hazard x; a map in which that is less than half of the free cells is drawn again.
#pragma once
#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/formats/read_case.hpp"

namespace waymark::plan {

enum class GridKind : std::uint8_t { Rooms, Maze, Scatter, Bridge, OneWay };  // the worlds above
// In the order of the names.
inline constexpr std::array<GridKind, 5> all_grid_kinds{GridKind::Rooms, GridKind::Maze, GridKind::Scatter,
                                                        GridKind::Bridge, GridKind::OneWay};
std::string_view name(GridKind kind);  // "rooms", "maze", "scatter", "bridge", "oneway"

struct GridRecipe {                                      // what is drawn
  static constexpr std::uint32_t most_landmarks = 20;    // a … t
  GridKind kind = GridKind::Rooms;                       // of world
  std::uint32_t width = 50, height = 50, landmarks = 3;  // cells, and places to go to
  // The chance to slip to each side, and to go back where there are hazards (bridge, scatter): noise to the sides
  // only lets one push against a side for ever and pass any of them.
  double noise = 0;
  std::uint64_t seed = 1;
  bool tasks = false;
};

struct GridText {                      // a grid as ltlgrid/1 writes it
  std::string name;                    // of the kind, the sizes and the seed
  std::vector<std::string> rows;       // characters of the legend
  std::uint32_t x = 0, y = 0;          // the start
  SlipChances motion;                  // of every move
  std::vector<std::string> landmarks;  // their names
  std::vector<CaseTask> tasks;         // for the landmarks
};

// Throws std::invalid_argument: sizes under 3 or more cells than a grid may have, too many landmarks, chances over 1,
// or no map of the kind found in a hundred drawings.
GridText generate_grid(const GridRecipe& recipe);

// ltlgrid/1, row by row.
void write_case(std::ostream& out, const GridText& grid);

}  // namespace waymark::plan
