// The cells of a block of a grid in strips that are swept side by side, and where their values stand.
//
// A strip is some rows of the grid, or some columns. It is swept in order and sees of its neighbours what they had
// after the pass before. So threads meet once a pass, and each keeps its own strips in its cache. How a block is cut
// depends on the block alone, and no number on the threads.
//
// Values stand line by line, in slots, so that a step adds the same to every slot of the block. Between two strips lie
// two lines more: in the first one the upper strip has copies of the lower one's first line, in the second one the
// lower strip has copies of the upper one's last.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/product/product.hpp"
#include "libplan/solve/exchange.hpp"
#include "libplan/solve/grid_cut.hpp"

namespace waymark::plan {

class GridStrips {
 public:
  using Order = std::vector<ProductState>;  // of the cells, as they are swept; their tasks are not looked at
  using Values = std::pmr::vector<double>;  // by slot

  // Chunks of so many cells, in their order, but for the last one. O(cells).
  GridStrips(const GridWorld& grid, const Order& order, std::size_t chunk_size);

  std::size_t count() const { return strips_.size(); }  // of strips
  std::size_t chunks() const { return chunks_; }        // of the order
  std::size_t cells() const { return cells_; }          // of the block
  std::uint32_t slots() const { return slots_; }        // that an array of values needs
  // By direction: what a move that is open adds to a slot.
  const std::array<std::int32_t, 4>& steps() const { return steps_; }
  std::uint32_t slot(std::uint32_t cell) const {  // of its own strip
    const std::uint32_t line = cut_.line(cell);
    return (line + 1 + 2 * cut_.strip_of[line]) * length_ + (cut_.by_columns ? cell / cut_.width : cell % cut_.width);
  }
  std::span<const std::uint32_t> chunk(std::size_t s, std::size_t chunk) const {  // its slots in a strip, in order
    const Strip& strip = strips_[s];
    return {strip.slots.data() + strip.first[chunk], strip.slots.data() + strip.first[chunk + 1]};
  }
  template <class Visit>  // visit(slot)
  void for_each_slot(Visit&& visit) const {
    for (const Strip& strip : strips_)
      for (const std::uint32_t slot : strip.slots) visit(slot);
  }
  template <class Visit>  // visit(cell, slot)
  void for_each(Visit&& visit) const {
    for (std::uint32_t s = 0; s < count(); ++s)
      for (const std::uint32_t slot : strips_[s].slots) visit(cell(slot - (1 + 2 * s) * length_), slot);
  }
  // The slot of whose value there is a copy one step away.
  std::uint32_t original(std::uint32_t slot, std::uint32_t copy) const {
    return copy > slot ? copy + 2 * length_ : copy - 2 * length_;
  }

  Exchange<double>& exchange() { return exchange_; }  // what strips see of their neighbours

 private:
  struct Strip {
    std::vector<std::uint32_t> slots, first;
    std::uint32_t first_line = 0, last_line = 0;  // of slots
  };
  std::uint32_t cell(std::uint32_t at) const {  // by line and place in the line
    return cut_.by_columns ? at % length_ * cut_.width + at / length_ : at;
  }

  GridCut cut_;
  std::uint32_t length_ = 0, slots_ = 0;  // of a line
  std::size_t cells_, chunks_;
  std::array<std::int32_t, 4> steps_{};
  std::vector<Strip> strips_;
  Exchange<double> exchange_;
};

}  // namespace waymark::plan
