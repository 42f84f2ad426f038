// The trapezoids of a terrain: its free space, cut into cells with one letter each [BCKO08, Sec. 6.1].
//
// Vertical lines through every corner and every crossing of edges cut the terrain into slabs in which no two edges
// cross. In a slab, the edges bound trapezoids. A passage is a piece of common border of positive length. A motion
// whose centre avoids corners crosses cells through passages, so every word of a motion is the word of a run through
// the cells.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/motion/terrain.hpp"

namespace waymark::plan {

struct Passage {         // from a cell into a neighbour
  std::uint32_t to = 0;  // the neighbour
  Point a, b;            // the common border
};

struct TerrainCell {              // a trapezoid
  std::array<Point, 4> corners;   // one after the other; two may coincide
  Point centre;                   // inside
  double area = 0;                // of the trapezoid
  std::uint32_t letter = 0;       // in TerrainCells::letters
  std::vector<Passage> passages;  // to its neighbours
};

class TerrainCells {  // the whole decomposition
 public:
  explicit TerrainCells(const Terrain& terrain);  // O((edges + crossings) · edges · regions)
  const std::vector<TerrainCell>& cells() const { return cells_; }
  const std::vector<ltl::Letter>& letters() const { return letters_; }  // that some cell has, each once
  std::optional<std::uint32_t> at(Point p) const;                       // nullopt: not free
  // The regions that contain the cell.
  const ltl::Letter& letter_of(std::uint32_t cell) const { return letters_[cells_[cell].letter]; }

 private:
  struct Slab {
    double left = 0, right = 0;
    std::uint32_t first = 0, last = 0;  // its cells, top to bottom: first … last − 1
  };
  void add_slab(const Terrain& terrain, const std::vector<Terrain::Edge>& edges, double left, double right);
  void add_cell(const Terrain& terrain, const std::array<Point, 4>& corners);
  void join(std::uint32_t a, std::uint32_t b, Point from, Point to);
  void join_slabs(const Slab& left, const Slab& right);

  std::vector<TerrainCell> cells_;
  std::vector<ltl::Letter> letters_;
  std::vector<Slab> slabs_;
};

}  // namespace waymark::plan
