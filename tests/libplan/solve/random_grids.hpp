// Small random grids: with three landmarks, and their tours by trying every order; with slips and hazards.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libplan/model/grid_world.hpp"

namespace waymark::plan::testing {

// A random grid with three landmarks, some of them on several cells; moves cost 1, or as much as their direction says.
inline GridWorld random_grid(ltl::Random& random, bool costs_differ = false) {
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
  GridWorld::Shape shape{.width = 5, .height = 4};
  if (costs_differ)
    for (double& cost : shape.cost) cost = 1 + static_cast<double>(random.below(5));
  return GridWorld(shape, vocabulary, palette, cells, 0);
}

// Walls, hazards x, one-way cells, landmarks a and b; chances and costs by move, some of them nothing. No move goes
// south, if so.
inline GridWorld noisy_grid(ltl::Random& random, bool never_south = false) {
  const ltl::Vocabulary names({"a", "b", "x"});
  std::vector<GridCell> palette(6);
  palette[1].wall = true;
  palette[2].one_way = all_compass[random.below(4)];
  for (std::uint32_t p = 0; p < 3; ++p) palette[3 + p].label = {ltl::Proposition{p}};
  std::vector<std::uint16_t> cells{0, 3, 4};
  while (cells.size() < 30) {
    const std::size_t kind = random.below(16);
    cells.push_back(static_cast<std::uint16_t>(kind < 6 ? kind : 0));
  }
  if (never_south) cells.back() = 0;
  GridWorld::Shape shape{.width = 6, .height = 5};
  for (std::size_t d = 0; d < 4; ++d) {
    SlipChances& slip = shape.motion[d];
    slip.left = 0.1 * static_cast<double>(random.below(3));
    slip.right = 0.1 * static_cast<double>(random.below(3));
    slip.back = 0.05 * static_cast<double>(random.below(3));
    slip.forward = 1 - slip.left - slip.right - slip.back;
    shape.cost[d] = 1 + static_cast<double>(random.below(3));
  }
  if (never_south)
    shape.motion = {SlipChances{.forward = 0.8, .left = 0.1, .right = 0.1},
                    {.forward = 0.75, .left = 0.25},
                    {.forward = 0, .left = 0.5, .right = 0.5},
                    {.forward = 0.5, .right = 0.25, .back = 0.25}};
  return GridWorld(shape, names, palette, cells, never_south ? 29 : 0);
}

// All pairs by relaxation, at least one move.
inline std::vector<std::vector<double>> distances(const GridWorld& grid) {
  const std::size_t n = grid.states();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, INFINITY));
  for (std::uint32_t s = 0; s < n; ++s)
    for (std::uint32_t k = 0; k < 4; ++k) d[s][grid.move(s, k)] = std::min(d[s][grid.move(s, k)], grid.cost(s, k));
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
      if (grid.letters()[grid.letter(s)].contains(ltl::Proposition{p}) && (s == grid.initial() || d[0][s] < INFINITY))
        places[p].push_back(s);
  double best = INFINITY;
  std::vector<std::size_t> order{0, 1, 2};
  do {
    for (std::uint32_t x : places[order[0]])
      for (std::uint32_t y : places[order[1]])
        for (std::uint32_t z : places[order[2]])
          best = std::min(best, closed ? d[x][y] + d[y][z] + d[z][x] : d[grid.initial()][x] + d[x][y] + d[y][z]);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

}  // namespace waymark::plan::testing
