#include "tools/distributed/grid_band.hpp"

namespace waymark::tools {

RowRange rows_of(int rank, int ranks, std::uint32_t height) {
  const auto begin = [&](int r) {
    return static_cast<std::uint32_t>(std::uint64_t{height} * static_cast<std::uint64_t>(r) /
                                      static_cast<std::uint64_t>(ranks));
  };
  return {begin(rank), begin(rank + 1)};
}

GridBand::GridBand(const plan::GridWorld& grid, RowRange rows)
    : shape_(grid.shape()),
      rows_(rows),
      step_{0U - shape_.width, 1, shape_.width, 0U - 1U},
      letters_(grid.letters()),
      letter_(std::size_t{rows.count() + 2} * shape_.width),
      open_(letter_.size(), 0) {
  const std::uint32_t w = width();
  for (std::uint32_t row = 0; row < rows.count() + 2; ++row) {
    const std::uint32_t y = rows.first + row - 1;  // wraps around above the grid
    if (y >= height()) continue;
    const bool is_halo = row == 0 || row == rows.count() + 1;
    for (std::uint32_t x = 0; x < w; ++x) {
      const std::uint32_t cell = y * w + x, place = row * w + x;
      letter_[place] = grid.letter(cell);
      for (std::uint32_t d = 0; d < 4 && !is_halo; ++d)
        if (grid.move(cell, d) != cell) open_[place] |= static_cast<std::uint8_t>(1U << d);
    }
  }
  const std::uint32_t start_row = grid.initial() / w;
  if (start_row >= rows.first && start_row < rows.last) start_ = grid.initial() - rows.first * w + w;
}

double GridBand::chance(std::uint32_t k, std::uint32_t d) const {
  const plan::SlipChances& slip = shape_.motion[k];
  return std::array<double, 4>{slip.forward, slip.right, slip.back, slip.left}[(d + 4 - k) % 4];
}

}  // namespace waymark::tools
