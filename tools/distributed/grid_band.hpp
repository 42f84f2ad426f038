// A band of a grid: the rows of one rank, and one row more on both sides, the halo, whose cells belong to the
// neighbours.
//
// A place is a cell of the band, numbered row by row from the upper halo on; where the grid ends the halo has cells
// that nothing leads to. Five bytes a place.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/model/grid_world.hpp"

namespace waymark::tools {

struct RowRange {  // first ≤ row < last
  std::uint32_t first = 0, last = 0;
  std::uint32_t count() const { return last - first; }
};

// Of as many rows as any other rank's, but for one.
RowRange rows_of(int rank, int ranks, std::uint32_t height);

class GridBand {
 public:
  // Of these rows of the grid, which is not needed afterwards. O(places).
  GridBand(const plan::GridWorld& grid, RowRange rows);

  RowRange rows() const { return rows_; }
  std::uint32_t width() const { return shape_.width; }    // in cells
  std::uint32_t height() const { return shape_.height; }  // of the grid, in cells
  std::uint32_t places() const { return static_cast<std::uint32_t>(letter_.size()); }
  // Its own places are [first_own, last_own).
  std::uint32_t first_own() const { return width(); }
  std::uint32_t last_own() const { return places() - width(); }
  bool is_own(std::uint32_t place) const { return place >= first_own() && place < last_own(); }
  std::optional<std::uint32_t> own_start() const { return start_; }  // the grid's start, where it is an own place

  const plan::Letters& letters() const { return letters_; }                    // of the grid
  plan::LetterId letter(std::uint32_t place) const { return letter_[place]; }  // that is read on entering
  bool is_open(std::uint32_t place, std::uint32_t d) const {                   // a move from an own place
    return ((open_[place] >> d) & 1U) != 0;
  }
  bool has_barred_move(std::uint32_t place) const { return open_[place] != 15U; }  // an own place
  // Where a move in that direction leads: from an own place, the place itself where it is barred.
  std::uint32_t move(std::uint32_t place, std::uint32_t d) const {
    return is_open(place, d) ? place + step_[d] : place;
  }
  std::uint32_t behind(std::uint32_t place, std::uint32_t d) const { return place - step_[d]; }
  double chance(std::uint32_t k, std::uint32_t d) const;  // that choice k leads in direction d
  double cost(std::uint32_t k) const { return shape_.cost[k]; }

 private:
  plan::GridWorld::Shape shape_;
  RowRange rows_;
  std::array<std::uint32_t, 4> step_;  // modulo 2³²
  plan::Letters letters_;
  std::vector<plan::LetterId> letter_;  // by place
  std::vector<std::uint8_t> open_;      // by place; 0 in the halo
  std::optional<std::uint32_t> start_;
};

}  // namespace waymark::tools
