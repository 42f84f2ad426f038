// Where a grid is cut into strips of rows, or of columns, that are swept side by side.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/product/product.hpp"

namespace waymark::plan {

struct GridCut {
  // Few enough that what strips see of each other is little beside their own; one where layers are thin, as in mazes,
  // whose ways cross from strip to strip.
  static std::size_t strips_for(std::size_t states, std::size_t chunk_size);

  // Strips with equal shares of these states, which are swept in this order, so many at a time. Of rows and columns
  // those that give two threads more equal work then. Some 65,000 states are looked at.
  static GridCut of(const GridWorld& grid, const std::vector<ProductState>& order, std::size_t chunk_size);

  // Of a cell: its row or column, and its strip.
  std::uint32_t line(std::uint32_t cell) const { return by_columns ? cell % width : cell / width; }
  std::uint32_t strip(std::uint32_t cell) const { return strip_of[line(cell)]; }  // likewise

  std::uint32_t width;                    // of the grid
  bool by_columns = false;                // or rows
  std::size_t strips = 1;                 // how many
  std::vector<std::uint32_t> strip_of{};  // by line
};

}  // namespace waymark::plan
