#include "libplan/model/grid_world.hpp"

#include <cmath>
#include <stdexcept>

namespace waymark::plan {
namespace {

void check(const GridWorld::Shape& shape, std::size_t palette, const std::vector<std::uint16_t>& cells) {
  const std::size_t size = std::size_t{shape.width} * shape.height;
  if (size == 0 || size > GridWorld::max_cells) throw std::invalid_argument("a grid without cells, or with too many");
  if (cells.size() != size) throw std::invalid_argument("not as many cells as the grid has");
  for (std::uint16_t kind : cells)
    if (kind >= palette) throw std::invalid_argument("a cell of no known kind");
  for (const SlipChances& c : shape.motion) {
    for (double chance : {c.forward, c.left, c.right, c.back})
      if (!(chance >= 0 && chance <= 1)) throw std::invalid_argument("a chance of a move outside of [0, 1]");
    if (!(std::abs(c.forward + c.left + c.right + c.back - 1) <= 1e-9))
      throw std::invalid_argument("the chances of a move do not add up to 1");
  }
  for (double cost : shape.cost)
    if (!(cost >= 0) || std::isinf(cost)) throw std::invalid_argument("a cost that is negative or infinite");
}

}  // namespace

std::string_view name(Compass direction) {
  static constexpr std::array<std::string_view, 4> names{"N", "E", "S", "W"};
  return names[static_cast<std::size_t>(direction)];
}

GridWorld::GridWorld(const Shape& shape, const ltl::Vocabulary& vocabulary, const std::vector<GridCell>& palette,
                     const std::vector<std::uint16_t>& cells, std::uint32_t start)
    : shape_(shape),
      start_(start),
      step_{0U - shape.width, 1, shape.width, 0U - 1U},
      letters_(vocabulary),
      kind_(cells) {
  check(shape, palette.size(), cells);
  for (std::size_t d = 0; d < 4; ++d) {
    const SlipChances& c = shape.motion[d];
    chance_[d] = {c.forward, c.right, c.back, c.left};
    for (std::uint8_t turn = 0; turn < 4; ++turn)
      if (chance_[d][turn] != 0) turns_[d][turn_count_[d]++] = turn, ++comes_[(d + turn) % 4];
    deterministic_ = deterministic_ && c.forward == 1;
  }
  for (const GridCell& cell : palette) {
    kind_letter_.push_back(letters_.intern(cell.label));
    wall_.push_back(cell.wall);
  }
  open_moves(palette);
  if (start >= cells.size()) throw std::invalid_argument("the start is off the grid");
  if (is_wall(start)) throw std::invalid_argument("the start is in a wall");
}

void GridWorld::open_moves(const std::vector<GridCell>& palette) {
  open_.assign(kind_.size(), 0);
  const auto passable = [&](const GridCell& cell, std::size_t d) {
    return !cell.wall && (!cell.one_way || static_cast<std::size_t>(*cell.one_way) == d);
  };
  for (std::uint32_t y = 0; y < height(); ++y)
    for (std::uint32_t x = 0; x < width(); ++x) {
      const std::uint32_t cell = y * width() + x;
      const std::array<bool, 4> inside{y > 0, x + 1 < width(), y + 1 < height(), x > 0};
      for (std::size_t d = 0; d < 4; ++d) {
        if (!inside[d]) continue;
        const std::uint32_t target = cell + step_[d];
        if (!passable(palette[kind_[cell]], d) || !passable(palette[kind_[target]], d)) continue;
        open_[cell] = static_cast<std::uint8_t>(open_[cell] | 1U << d);
        open_[target] = static_cast<std::uint8_t>(open_[target] | 16U << d);
      }
    }
}

}  // namespace waymark::plan
