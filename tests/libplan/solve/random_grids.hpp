// Small random grids with three landmarks, and their tours by trying every order.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "libltl/random.hpp"
#include "libplan/model/grid_world.hpp"

namespace waymark::plan::testing {

// A random grid with three landmarks, some of them on several cells.
inline GridWorld random_grid(ltl::Random& random) {
  ltl::Vocabulary vocabulary;
  std::vector<GridCell> palette{{}, {.wall = true}};
  for (const char* name : {"a", "b", "c"}) {
    GridCell& cell = palette.emplace_back();
    cell.label.insert(vocabulary.add(name));
  }
  std::vector<std::uint16_t> cells{0};
  for (int i = 1; i < 20; ++i) {
    const std::size_t r = random.below(10);
    cells.push_back(static_cast<std::uint16_t>(r < 5 ? 0 : r < 7 ? 1 : r - 5));
  }
  return GridWorld({.width = 5, .height = 4}, vocabulary, palette, cells, 0);
}

// All pairs by relaxation, at least one move.
inline std::vector<std::vector<double>> distances(const GridWorld& grid) {
  const std::size_t n = grid.states();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, INFINITY));
  for (std::uint32_t s = 0; s < n; ++s)
    for (std::uint32_t k = 0; k < 4; ++k) d[s][grid.move(s, k)] = 1;
  for (std::size_t m = 0; m < n; ++m)
    for (std::size_t s = 0; s < n; ++s)
      for (std::size_t t = 0; t < n; ++t) d[s][t] = std::min(d[s][t], d[s][m] + d[m][t]);
  return d;
}

inline double tour_by_enumeration(const GridWorld& grid, bool closed) {
  const auto d = distances(grid);
  std::vector<std::vector<std::uint32_t>> places(3);
  for (std::uint32_t s = 0; s < grid.states(); ++s)
    for (std::uint32_t p = 0; p < 3; ++p)
      if (grid.letters()[grid.letter(s)].contains(ltl::Proposition{p}) &&
          (s == grid.initial() || d[0][s] < INFINITY))
        places[p].push_back(s);
  double best = INFINITY;
  std::vector<std::size_t> order{0, 1, 2};
  do {
    for (std::uint32_t x : places[order[0]])
      for (std::uint32_t y : places[order[1]])
        for (std::uint32_t z : places[order[2]])
          best =
              std::min(best, closed ? d[x][y] + d[y][z] + d[z][x] : d[grid.initial()][x] + d[x][y] + d[y][z]);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

}  // namespace waymark::plan::testing
