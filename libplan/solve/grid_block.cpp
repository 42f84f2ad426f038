#include "libplan/solve/grid_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace waymark::plan {

GridBlock::GridBlock(const Product& product, Measure measure, const Order& order, const Strategy* only)
    : product_(product), measure_(measure), only_(only), margin_(product.model().width()) {
  const std::size_t cells = product.model().states();
  task_ = order.front().task;
  for (const auto& c : order) cells_.push_back(c.place);
  code_.assign(cells, 0);
  known_.assign(cells, 0);
  unknown_.assign(cells, false);
  for (std::uint32_t cell : cells_) unknown_[cell] = true;
  lower_.assign(cells + 2 * std::size_t{margin_}, 0);
  upper_ = lower_;
}

std::optional<GridBlock> GridBlock::of(const Product& product, const Unknowns& unknowns, Measure measure,
                                       const Order& order, const std::vector<double>& lower,
                                       const std::vector<double>& upper, const Strategy* only) {
  if (measure == Measure::MinProbability || !product.task().jumps(order.front().task).empty())
    return std::nullopt;
  for (const auto& c : order) {
    const bool merged =
        unknowns.merged.count > 0 && unknowns.merged.of[product.state(c).index] != EndComponents::none;
    if (merged || c.task != order.front().task) return std::nullopt;
  }
  GridBlock block(product, measure, order, only);
  if (!block.read(unknowns, lower, upper)) return std::nullopt;
  block.tabulate();
  return block;
}

// The chance that a choice leads in a direction when nothing is barred.
double GridBlock::chance(std::uint32_t choice, std::uint32_t direction) const {
  const SlipChances& slip = product_.model().shape().motion[choice];
  return std::array<double, 4>{slip.forward, slip.right, slip.back, slip.left}[(direction + 4 - choice) % 4];
}

bool GridBlock::read(const Unknowns& unknowns, const std::vector<double>& lower,
                     const std::vector<double>& upper) {
  return std::all_of(cells_.begin(), cells_.end(),
                     [&](std::uint32_t cell) { return read_cell(cell, unknowns, lower, upper); });
}

// What its neighbours are, and which choices count. False: not of this kind.
bool GridBlock::read_cell(std::uint32_t cell, const Unknowns& unknowns, const std::vector<double>& lower,
                          const std::vector<double>& upper) {
  const GridWorld& grid = product_.model();
  std::uint32_t open = 0, good = 0;
  for (std::uint32_t d = 0; d < 4; ++d) {
    bool comes_here = false;
    for (std::uint32_t k = 0; k < 4; ++k) comes_here = comes_here || chance(k, d) > 0;
    const std::uint32_t to = grid.move(cell, d);
    const std::uint32_t q = product_.task().next(task_, grid.letter(to)).target;
    if (to == cell) {
      if (comes_here && q != task_) return false;  // to stay is to go on to another task
      continue;
    }
    open |= 1U << d;
    if (!comes_here) continue;
    if (unknown_[to] != (q == task_ && unknown_[to])) return false;  // met with two tasks
    if (unknown_[to]) {
      good |= 1U << d;
      continue;
    }
    if (q == TaskTable::lost) continue;
    const std::uint32_t t = product_.state(Product::Compact{to, q}).index;
    if (!unknowns.targets[t] && !unknowns.unknown[t]) continue;
    if (unknowns.unknown[t] && q == task_) return false;
    good |= 1U << d;
    lower_[to + margin_] = lower[t];
    upper_[to + margin_] = upper[t];
  }
  std::uint32_t choices = counted(open, good);
  if (only_ != nullptr) choices &= 16U << only_->choice[product_.state(Product::Compact{cell, task_}).index];
  code_[cell] = static_cast<std::uint8_t>(open | choices);
  known_[cell] = static_cast<std::uint8_t>(good);
  return true;
}

// The choices that count, in bits 4 to 7: they lead somewhere, and, where costs are asked for, nowhere that is lost.
std::uint32_t GridBlock::counted(std::uint32_t open, std::uint32_t good) const {
  std::uint32_t out = 0;
  for (std::uint32_t k = 0; k < 4; ++k) {
    double leaves = 0;
    bool all_good = true;
    for (std::uint32_t d = 0; d < 4; ++d) {
      if (((open >> d) & 1U) == 0 || chance(k, d) == 0) continue;
      leaves += chance(k, d);
      all_good = all_good && ((good >> d) & 1U) != 0;
    }
    if (leaves > 1e-12 && (all_good || is_probability(measure_))) out |= 16U << k;
  }
  return out;
}

// A choice that may come to nothing is taken until it comes to something: divided by the chance that it does.
void GridBlock::tabulate() {
  const double never = measure_ == Measure::MinCost ? INFINITY : -1;
  rows_.resize(256);
  for (std::uint32_t code = 0; code < 256; ++code)
    for (std::uint32_t k = 0; k < 4; ++k) {
      double leaves = 0;
      for (std::uint32_t d = 0; d < 4; ++d)
        if (((code >> d) & 1U) != 0) leaves += chance(k, d);
      const bool counts = ((code >> (4 + k)) & 1U) != 0 && leaves > 0;
      for (std::uint32_t d = 0; d < 4; ++d)
        rows_[code].chance[d][k] = counts && ((code >> d) & 1U) != 0 ? chance(k, d) / leaves : 0;
      const double cost = measure_ == Measure::MinCost ? product_.model().shape().cost[k] : 0;
      rows_[code].cost[k] = counts ? cost / leaves : never;
    }
  if (only_ == nullptr) return;
  for (std::uint32_t code = 0; code < 256; ++code) {
    const std::size_t k = code < 16 ? 0 : static_cast<std::size_t>(std::countr_zero(code >> 4U));
    Only& row = only_rows_.emplace_back();
    row.cost = rows_[code].cost[k];
    for (std::size_t d = 0; d < 4; ++d) row.chance[d] = rows_[code].chance[d][k];
  }
}

inline std::array<double, 4> GridBlock::around(std::uint32_t cell, const std::vector<double>& x) const {
  const double* here = x.data() + cell + margin_;
  return {*(here - margin_), *(here + 1), *(here + margin_), *(here - 1)};
}

inline double GridBlock::of_strategy(std::uint32_t cell, const std::vector<double>& x) const {
  const Only& row = only_rows_[code_[cell]];
  const std::array<double, 4> values = around(cell, x);
  double sum = row.cost;
  for (std::size_t d = 0; d < 4; ++d) sum += row.chance[d] * values[d];
  return sum;
}

inline double GridBlock::best(std::uint32_t cell, const std::vector<double>& x) const {
  if (only_ != nullptr) return of_strategy(cell, x);
  const Row& row = rows_[code_[cell]];
  const std::array<double, 4> values = around(cell, x);
  std::array<double, 4> offered = row.cost;
  for (std::size_t d = 0; d < 4; ++d)
    for (std::size_t k = 0; k < 4; ++k) offered[k] += row.chance[d][k] * values[d];
  if (measure_ == Measure::MinCost)
    return std::min(std::min(offered[0], offered[1]), std::min(offered[2], offered[3]));
  return std::max(std::max(std::max(offered[0], offered[1]), std::max(offered[2], offered[3])), 0.0);
}

// As Equations does it: the least way if every move went where one would wish.
void GridBlock::start_from_best_luck() {
  const GridWorld& grid = product_.model();
  const auto& costs = grid.shape().cost;
  const double step = *std::min_element(costs.begin(), costs.end());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  for (std::uint32_t cell : cells_) {
    double least = INFINITY;
    for (std::uint32_t d = 0; d < 4; ++d)
      if (const std::uint32_t to = grid.move(cell, d); ((known_[cell] >> d) & 1U) != 0 && !unknown_[to])
        least = std::min(least, step + lower_[to + margin_]);
    lower_[cell + margin_] = least;
    if (least < INFINITY) heap.push({least, cell});
  }
  while (!heap.empty()) {
    const double cost = heap.top().first;
    const std::uint32_t cell = heap.top().second;
    heap.pop();
    if (cost > lower_[cell + margin_]) continue;
    grid.for_each_predecessor(cell, [&](std::uint32_t from) {
      if (!unknown_[from] || lower_[from + margin_] <= cost + step) return;
      lower_[from + margin_] = cost + step;
      heap.push({cost + step, from});
    });
  }
}

void GridBlock::start_from(const std::vector<double>& lower, const std::vector<double>& upper) {
  for (std::uint32_t cell : cells_) {
    const std::uint32_t i = product_.state(Product::Compact{cell, task_}).index;
    lower_[cell + margin_] = lower[i];
    upper_[cell + margin_] = upper[i];
  }
  started_ = std::none_of(cells_.begin(), cells_.end(), [&](std::uint32_t cell) {
    return raises(best(cell, lower_), lower_[cell + margin_]);
  });
}

double GridBlock::raise() {
  double change = 0;
  for (std::uint32_t cell : cells_) {
    double& value = lower_[cell + margin_];
    const double now = best(cell, lower_);
    if (!(now > value)) continue;
    change = std::max(change, is_probability(measure_) ? now - value : (now - value) / now);
    value = now;
  }
  return change;
}

bool GridBlock::close_from_above() {
  bool inductive = true;
  for (std::uint32_t cell : cells_) {
    double& value = upper_[cell + margin_];
    const double now = best(cell, upper_);
    inductive = inductive && (!raises(value, now) || (is_probability(measure_) && value == 1));
    value = std::min(value, now);
  }
  return inductive;
}

void GridBlock::guess_above(double tolerance) {
  for (std::uint32_t cell : cells_) {
    const double lower = lower_[cell + margin_];
    upper_[cell + margin_] =
        is_probability(measure_) ? std::min(1.0, lower + tolerance / 2) : lower * (1 + tolerance / 2);
  }
}

bool GridBlock::closer_than(double tolerance) const {
  return std::all_of(cells_.begin(), cells_.end(), [&](std::uint32_t cell) {
    return upper_[cell + margin_] <= lower_[cell + margin_] * (1 + tolerance);
  });
}

bool GridBlock::prove(std::uint64_t sweeps) {
  for (std::uint64_t tries = 0; tries < sweeps; ++tries, ++sweeps_)
    if (close_from_above()) return true;
  return false;
}

// From below much finer than the tolerance asks for: guesses are proved in a few sweeps then, or not at all.
std::optional<std::uint64_t> GridBlock::solve(const IterationLimits& limits) {
  constexpr std::uint64_t some_tries = 16;
  if (started_ && closer_than(limits.tolerance) && prove(some_tries)) return sweeps_;
  if (measure_ == Measure::MinCost && !started_) start_from_best_luck();
  for (double fine = limits.tolerance / 1024;; fine = fine < 1e-18 ? 0 : fine / 64) {
    const std::uint64_t before = sweeps_;
    do {
      if (sweeps_ > limits.sweeps || limits.stop.stop_requested()) return std::nullopt;
      ++sweeps_;
    } while (raise() > fine);
    guess_above(limits.tolerance);
    if (prove((sweeps_ - before) / 2 + some_tries)) return sweeps_;
    if (fine == 0) return std::nullopt;
  }
}

}  // namespace waymark::plan
