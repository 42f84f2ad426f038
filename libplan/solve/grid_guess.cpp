// How a block of a grid begins: costs that are guessed, and by how much steps are lengthened.
#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "libplan/solve/grid_block.hpp"
#include "libplan/solve/guessed_steps.hpp"

namespace waymark::plan {

// With which chance a move goes where it should, once it goes anywhere: the best choice, the mean over the cells.
double GridBlock::likely() const {
  double sum = 0;
  strips_.for_each_slot([&](std::uint32_t slot) {
    const Row& row = rows_[code_[slot]];
    double best = 0;
    for (std::size_t k = 0; k < 4; ++k) best = std::max(best, row.chance[k][k]);
    sum += best;
  });
  return sum / static_cast<double>(strips_.cells());
}

double GridBlock::over_relaxation() const { return over_relaxation_of(likely()); }

// What is better said of a cell's value than nothing: the least way if every move went where one would wish, in guessed
// steps.
void GridBlock::guess_costs() {
  const GridWorld& grid = product_.model();
  set_around(Side::Middle);
  const double forward = likely();
  double step = 0;
  for (std::uint32_t k = 0; k < 4; ++k)
    step = std::max(step, guessed_step(grid.shape().cost[k], forward, chance(k, (k + 2) % 4)));
  const std::array<std::int32_t, 4>& steps = strips_.steps();
  std::vector<std::pair<double, std::uint32_t>> next_to_known;
  strips_.for_each_slot([&](std::uint32_t slot) {
    double least = INFINITY;
    for (std::uint32_t d = 0; d < 4; ++d)
      if (const std::uint32_t to = slot + static_cast<std::uint32_t>(steps[d]);
          ((marks_[slot] >> d) & 1U) != 0 && (marks_[to] & (unknown | copy)) == 0)
        least = std::min(least, step + lower_[to]);
    lower_[slot] = least;
    if (least < INFINITY) next_to_known.emplace_back(least, slot);
  });
  // All steps are as long: what has been reached comes in ascending order, and so do those it starts from.
  std::sort(next_to_known.begin(), next_to_known.end());
  std::deque<std::uint32_t> reached;
  for (std::size_t first = 0; first < next_to_known.size() || !reached.empty();) {
    std::uint32_t slot = 0;
    if (reached.empty() || (first < next_to_known.size() && next_to_known[first].first <= lower_[reached.front()])) {
      slot = next_to_known[first].second;
      if (next_to_known[first++].first > lower_[slot]) continue;
    } else {
      slot = reached.front();
      reached.pop_front();
    }
    const double cost = lower_[slot] + step;
    for (std::uint32_t d = 0; d < 4; ++d) {  // from the cell that lies behind a move in direction d
      std::uint32_t from = slot - static_cast<std::uint32_t>(steps[d]);
      if ((marks_[from] & copy) != 0) from = strips_.original(slot, from);
      if ((marks_[from] & unknown) == 0 || ((code_[from] >> d) & 1U) == 0 || lower_[from] <= cost) continue;
      lower_[from] = cost;
      reached.push_back(from);
    }
  }
}

}  // namespace waymark::plan
