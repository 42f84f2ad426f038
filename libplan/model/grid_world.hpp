// Grid worlds: cells with four moves that may slip, kept implicit.
//
// A state is a cell, y · width + x, y growing downwards; the choices are the moves N E S W, always all four. A move
// goes forward with the given probability, else to the left, right or back of where it was meant to go; against a wall,
// off the grid, or against a one-way cell it stays where it is. A one-way cell is entered and left in its direction
// only. The letter of an outcome is that of the cell it leads into. Three bytes a cell; successors are computed when
// asked for, so that grids of millions of cells fit.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/model.hpp"

namespace waymark::plan {

enum class Compass : std::uint8_t { North, East, South, West };  // directions of moves
// In the order of the choices.
inline constexpr std::array<Compass, 4> all_compass{Compass::North, Compass::East, Compass::South, Compass::West};
std::string_view name(Compass direction);  // "N", "E", "S", "W"

struct SlipChances {                                  // where a move goes; in sum 1
  double forward = 1, left = 0, right = 0, back = 0;  // of what was meant
  friend bool operator==(const SlipChances&, const SlipChances&) = default;
};

struct GridCell {                       // one square
  bool wall = false;                    // cannot be entered
  std::optional<Compass> one_way = {};  // entered and left in that direction only
  ltl::Letter label = {};               // what holds there
};

class GridWorld {
 public:
  static constexpr std::size_t max_cells = std::size_t{1} << 28U;  // cells of the largest grid
  static constexpr std::size_t max_letters = 1U << 16U;            // different labels of the largest grid

  struct Shape {                                // of a grid
    std::uint32_t width = 0, height = 0;        // in cells
    std::array<SlipChances, 4> motion = {};     // by the direction that was meant
    std::array<double, 4> cost = {1, 1, 1, 1};  // of a move
  };
  // Every cell has an index into `palette`: row by row. Throws std::invalid_argument naming the fault: sizes, chances
  // that do not add up to 1, a start off the grid or in a wall.
  GridWorld(const Shape& shape, const ltl::Vocabulary& vocabulary, const std::vector<GridCell>& palette,
            const std::vector<std::uint16_t>& cells, std::uint32_t start);

  std::uint32_t width() const { return shape_.width; }                   // in cells
  std::uint32_t height() const { return shape_.height; }                 // in cells
  const Shape& shape() const { return shape_; }                          // as it was given
  bool is_deterministic() const { return deterministic_; }               // no move slips
  bool is_wall(std::uint32_t cell) const { return wall_[kind_[cell]]; }  // or free

  // What the concept of a model (model.hpp) asks.
  std::size_t states() const { return open_.size(); }
  std::uint32_t initial() const { return start_; }
  LetterId initial_letter() const { return letter(start_); }
  const Letters& letters() const { return letters_; }
  std::uint32_t choices(std::uint32_t) const { return 4; }
  double cost(std::uint32_t, std::uint32_t k) const { return shape_.cost[k]; }
  std::string_view action(std::uint32_t, std::uint32_t k) const { return plan::name(all_compass[k]); }
  std::string name(std::uint32_t s) const {
    return std::to_string(s % shape_.width) + ',' + std::to_string(s / shape_.width);
  }
  LetterId letter(std::uint32_t cell) const { return kind_letter_[kind_[cell]]; }  // that is read on entering
  // Where a move in that direction ends when it does not slip: the cell itself when it is barred.
  std::uint32_t move(std::uint32_t cell, std::uint32_t direction) const {
    return ((open_[cell] >> direction) & 1U) != 0 ? cell + step_[direction] : cell;
  }

  // What the concept of a model asks of outcomes.
  std::uint32_t outcome_count(std::uint32_t, std::uint32_t k) const { return turn_count_[k]; }
  ModelOutcome outcome(std::uint32_t s, std::uint32_t k, std::uint32_t i) const {
    const std::uint32_t turn = turns_[k][i], target = move(s, (k + turn) % 4);
    return {target, letter(target), chance_[k][turn]};
  }
  template <class Visit>  // visit(target, letter, probability); a target may come twice
  void for_each_outcome(std::uint32_t s, std::uint32_t k, Visit&& visit) const {
    const std::array<double, 4>& chance = chance_[k];
    for (std::uint32_t turn = 0; turn < 4; ++turn) {
      if (chance[turn] == 0) continue;
      const std::uint32_t target = move(s, (k + turn) % 4);
      visit(target, letter(target), chance[turn]);
    }
  }
  // visit(target, letter, times): where some choice may lead, each cell once; by how many outcomes of all choices.
  template <class Visit>
  void for_each_target(std::uint32_t s, Visit&& visit) const {
    std::uint32_t stays = 0;
    for (std::uint32_t d = 0; d < 4; ++d) {
      if (((open_[s] >> d) & 1U) == 0)
        stays += comes_[d];
      else if (comes_[d] > 0)
        visit(s + step_[d], letter(s + step_[d]), comes_[d]);
    }
    if (stays > 0) visit(s, letter(s), stays);
  }
  template <class Visit>  // visit(source): the cells with an outcome into s, each once
  void for_each_predecessor(std::uint32_t s, Visit&& visit) const {
    if ((open_[s] & 15U) != 15U) visit(s);  // some move is barred
    for (std::uint32_t d = 0; d < 4; ++d)   // from the cell that lies behind a move in direction d
      if (((open_[s] >> (4 + d)) & 1U) != 0) visit(s - step_[d]);
  }

 private:
  void open_moves(const std::vector<GridCell>& palette);

  Shape shape_;
  bool deterministic_ = true;
  std::uint32_t start_;
  std::array<std::uint32_t, 4> step_;  // what a move adds to the number of a cell, modulo 2³²
  // By direction meant, by turn to the right: forward, right, back, left. The turns that have a chance, ascending.
  std::array<std::array<double, 4>, 4> chance_;
  std::array<std::array<std::uint8_t, 4>, 4> turns_{};
  std::array<std::uint8_t, 4> turn_count_{};
  std::array<std::uint32_t, 4> comes_{};  // by direction: how many choices have a chance to go there
  Letters letters_;
  std::vector<std::uint16_t> kind_;    // by cell: its place in the palette
  std::vector<LetterId> kind_letter_;  // by place in the palette
  std::vector<bool> wall_;
  std::vector<std::uint8_t> open_;  // by cell: bit d, a move in direction d leads on; bit 4 + d, one leads in
};

static_assert(TargetModel<GridWorld>);

}  // namespace waymark::plan
