#include "libplan/solve/grid_bound.hpp"

#include <algorithm>

namespace waymark::plan {

std::vector<GridBound::Box> GridBound::boxes_of(const GridWorld& grid) {
  std::vector<Box> boxes(grid.letters().size());
  for (std::uint32_t y = 0, cell = 0; y < grid.height(); ++y)
    for (std::uint32_t x = 0; x < grid.width(); ++x, ++cell) {
      if (grid.is_wall(cell)) continue;
      Box& box = boxes[grid.letter(cell).index];
      box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
    }
  return boxes;
}

std::uint32_t GridBound::moves_between(const Box& a, const Box& b) {
  const auto gap = [](std::uint32_t low_a, std::uint32_t high_a, std::uint32_t low_b, std::uint32_t high_b) {
    return low_b > high_a ? low_b - high_a : low_a > high_b ? low_a - high_b : 0;
  };
  return std::max(1U, gap(a.left, a.right, b.left, b.right) + gap(a.top, a.bottom, b.top, b.bottom));
}

std::optional<GridBound> GridBound::of(const GridWorld& grid, const TaskTable& task) {
  const std::size_t letters = grid.letters().size(), states = task.states();
  if (letters * letters * states > most_terms) return std::nullopt;
  const std::vector<Box> boxes = boxes_of(grid);
  std::vector<std::uint32_t> rest(letters * states, never);  // G, by state and letter
  const auto improve = [&](std::uint32_t q) {
    bool better = false;
    for (std::uint32_t to = 0; to < letters; ++to) {
      const std::uint32_t target = task.next(q, {to}).target;
      if (target == TaskTable::trap || target == q || boxes[to].left > boxes[to].right) continue;
      const std::uint32_t then = rest[target * letters + to];
      if (then == never) continue;
      for (std::size_t from = 0; from < letters; ++from) {
        if (boxes[from].left > boxes[from].right) continue;
        std::uint32_t& known = rest[q * letters + from];
        const std::uint32_t now = moves_between(boxes[from], boxes[to]) + then;
        better = better || now < known;
        known = std::min(known, now);
      }
    }
    return better;
  };
  for (std::uint32_t q = 0; q < states; ++q)
    if (task.is_goal(q)) std::fill_n(rest.begin() + static_cast<std::ptrdiff_t>(q * letters), letters, 0);
  // No step leads to a higher component: those below are known.
  const std::vector<std::uint32_t>& components = task.components();
  for (std::size_t c = 0; c + 1 < components.size(); ++c)
    for (bool better = true; better;) {
      better = false;
      for (std::uint32_t q = components[c]; q < components[c + 1]; ++q)
        if (!task.is_goal(q) && improve(q)) better = true;
    }

  GridBound out(grid.width());
  for (std::uint32_t q = 0; q < states; ++q) {
    out.goal_.push_back(task.is_goal(q));
    out.first_.push_back(static_cast<std::uint32_t>(out.ways_.size()));
    for (std::uint32_t to = 0; to < letters && !task.is_goal(q); ++to) {
      const std::uint32_t target = task.next(q, {to}).target;
      if (target == TaskTable::trap || target == q || boxes[to].left > boxes[to].right) continue;
      if (const std::uint32_t then = rest[target * letters + to]; then != never) out.ways_.push_back({boxes[to], then});
    }
  }
  out.first_.push_back(static_cast<std::uint32_t>(out.ways_.size()));
  return out;
}

std::uint32_t GridBound::operator()(std::uint32_t cell, std::uint32_t q) const {
  if (goal_[q]) return 0;
  const std::uint32_t x = cell % width_, y = cell / width_;
  std::uint32_t best = never;
  for (std::uint32_t i = first_[q]; i < first_[q + 1]; ++i)
    best = std::min(best, moves_between({x, x, y, y}, ways_[i].through) + ways_[i].rest);
  return best;
}

}  // namespace waymark::plan
