// A lower bound on the moves that a cell and a state of the task are away from acceptance: the heuristic of A* on
// grids.
//
// To get on, the task must leave its state q by a letter λ, that is in a cell of the box B(λ) around all cells that
// show λ; from there it leaves the state it came to, and so on. With |·| the moves between boxes on a grid without
// walls,
//
//   G(λ, q) = 0 where q accepts, else  min over λ' with q' = δ(q, λ') ≠ q, q' no trap:  max(1, |B(λ), B(λ')|) + G(λ',
//     q')
//   h(p, q) = the same with the cell p in the place of B(λ)
//
// so a task of waypoints is seen to its end, as if there were no walls. Nothing is searched: O(letters² · states) once,
// O(ways out of q) when asked. Admissible, as every move is one step; consistent, because a move that keeps q changes
// |p, B| by one at most, and one that leaves q comes into B(λ).
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/product/task_table.hpp"

namespace waymark::plan {

class GridBound {
 public:
  static constexpr std::uint32_t never = UINT32_MAX;                // proved: nothing accepting is within reach
  static constexpr std::size_t most_terms = std::size_t{1} << 22U;  // of a task; larger tasks have no bound

  // nullopt: more than `most_terms` letters² · states to look at.
  static std::optional<GridBound> of(const GridWorld& grid, const TaskTable& task);

  std::uint32_t operator()(std::uint32_t cell, std::uint32_t q) const;

 private:
  struct Box {
    std::uint32_t left = UINT32_MAX, right = 0, top = UINT32_MAX, bottom = 0;
  };
  struct WayOut {  // of a state: through a box, and what is left from there
    Box through;
    std::uint32_t rest;
  };
  explicit GridBound(std::uint32_t width) : width_(width) {}
  static std::vector<Box> boxes_of(const GridWorld& grid);
  static std::uint32_t moves_between(const Box& a, const Box& b);

  std::uint32_t width_;
  std::vector<bool> goal_;
  std::vector<std::uint32_t> first_;  // by state: its ways out, up to those of the next
  std::vector<WayOut> ways_;
};

}  // namespace waymark::plan
