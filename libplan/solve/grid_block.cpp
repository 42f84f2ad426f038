#include "libplan/solve/grid_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "libplan/solve/guessed_steps.hpp"

namespace waymark::plan {

GridBlock::GridBlock(const Product& product, Measure measure, Order order, const Strategy* only,
                     std::pmr::memory_resource* memory)
    : product_(product),
      measure_(measure),
      only_(only),
      margin_(product.model().width()),
      lower_(memory),
      upper_(memory) {
  const std::size_t cells = product.model().states();
  task_ = order.front().task;
  cells_.reserve(order.size());
  for (const auto& c : order) cells_.push_back(c.place);
  Order().swap(order);  // its memory is that of what follows
  code_.resize(cells);
  known_.resize(cells);
  unknown_.assign(cells, false);
  for (std::uint32_t cell : cells_) unknown_[cell] = true;
  lower_.assign(cells + 2 * std::size_t{margin_}, 0);
  upper_.assign(lower_.size(), 0);
}

std::optional<GridBlock> GridBlock::of(const Product& product, const Unknowns& unknowns, Measure measure, Order order,
                                       const KeptBounds& known, const Strategy* only,
                                       std::pmr::memory_resource* memory) {
  if (!product.task().jumps(order.front().task).empty()) return std::nullopt;
  for (const auto& c : order) {
    const bool merged = unknowns.merged.count > 0 && unknowns.merged.of[product.state(c).index] != EndComponents::none;
    if (merged || c.task != order.front().task) return std::nullopt;
  }
  GridBlock block(product, measure, std::move(order), only, memory);
  if (!block.read(unknowns, known)) return std::nullopt;
  block.tabulate();
  return block;
}

// The chance that a choice leads in a direction when nothing is barred.
double GridBlock::chance(std::uint32_t choice, std::uint32_t direction) const {
  const SlipChances& slip = product_.model().shape().motion[choice];
  return std::array<double, 4>{slip.forward, slip.right, slip.back, slip.left}[(direction + 4 - choice) % 4];
}

bool GridBlock::read(const Unknowns& unknowns, const KeptBounds& known) {
  return std::all_of(cells_.begin(), cells_.end(),
                     [&](std::uint32_t cell) { return read_cell(cell, unknowns, known); });
}

// What its neighbours are, and which choices count. False: not of this kind.
bool GridBlock::read_cell(std::uint32_t cell, const Unknowns& unknowns, const KeptBounds& known) {
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
    if (q == TaskTable::trap) continue;
    const std::uint32_t t = product_.state(Product::Compact{to, q}).index;
    if (!unknowns.targets[t] && !unknowns.unknown[t]) continue;
    if (unknowns.unknown[t] && q == task_) return false;
    good |= 1U << d;
    const double target = is_probability(measure_) ? 1 : 0;
    around_.push_back(unknowns.targets[t] ? Around{to, target, target} : Around{to, known.lower(t), known.upper(t)});
  }
  std::uint32_t choices = counted(open, good);
  if (only_ != nullptr) choices &= 16U << only_->choice[product_.state(Product::Compact{cell, task_}).index];
  code_[cell] = static_cast<std::uint8_t>(open | choices);
  known_[cell] = static_cast<std::uint8_t>(good);
  return true;
}

// The choices that count, in bits 4 to 7, if they lead somewhere: where costs are asked for, not into the trap.
std::uint32_t GridBlock::counted(std::uint32_t open, std::uint32_t good) const {
  std::uint32_t out = 0;
  for (std::uint32_t k = 0; k < 4; ++k) {
    bool all_good = true;
    for (std::uint32_t d = 0; d < 4; ++d)
      if (((open >> d) & 1U) != 0 && chance(k, d) > 0) all_good = all_good && ((good >> d) & 1U) != 0;
    if (all_good || is_probability(measure_)) out |= 16U << k;
  }
  return out;
}

// A choice that may come to nothing is taken until it comes to something: divided by the chance that it does.
void GridBlock::tabulate() {
  const auto down = static_cast<std::int32_t>(margin_);
  const std::array<std::int32_t, 4> all{-down, 1, down, -1};
  for (std::uint32_t open = 0; open < 16; ++open)
    for (std::size_t d = 0; d < 4; ++d) steps_[open][d] = ((open >> d) & 1U) != 0 ? all[d] : 0;
  const double never = measure_ == Measure::MinCost ? INFINITY : -1;
  rows_.resize(256);
  for (std::uint32_t code = 0; code < 256; ++code)
    for (std::uint32_t k = 0; k < 4; ++k) {
      double leaves = 0;
      for (std::uint32_t d = 0; d < 4; ++d)
        if (((code >> d) & 1U) != 0) leaves += chance(k, d);
      const bool counts = ((code >> (4 + k)) & 1U) != 0 && leaves > 1e-12;
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

// The neighbours' values; the cell's own where a move is barred.
inline std::array<double, 4> GridBlock::around(std::uint32_t cell, const Values& x) const {
  const double* here = x.data() + cell + margin_;
  const std::array<std::int32_t, 4>& to = steps_[code_[cell] & 15U];
  return {here[to[0]], here[to[1]], here[to[2]], here[to[3]]};
}

inline double GridBlock::of_strategy(std::uint32_t cell, const Values& x) const {
  const Only& row = only_rows_[code_[cell]];
  const std::array<double, 4> values = around(cell, x);
  double sum = row.cost;
  for (std::size_t d = 0; d < 4; ++d) sum += row.chance[d] * values[d];
  return sum;
}

inline double GridBlock::best(std::uint32_t cell, const Values& x) const {
  if (only_ != nullptr) return of_strategy(cell, x);
  const Row& row = rows_[code_[cell]];
  const std::array<double, 4> values = around(cell, x);
  std::array<double, 4> offered = row.cost;
  for (std::size_t d = 0; d < 4; ++d)
    for (std::size_t k = 0; k < 4; ++k) offered[k] += row.chance[d][k] * values[d];
  if (measure_ == Measure::MinCost) return std::min(std::min(offered[0], offered[1]), std::min(offered[2], offered[3]));
  return std::max(std::max(std::max(offered[0], offered[1]), std::max(offered[2], offered[3])), 0.0);
}

// What is known around the block: the bounds, or what lies between them.
void GridBlock::set_around(Side side) {
  for (const Around& a : around_) {
    lower_[a.cell + margin_] = side == Side::Middle ? a.lower + (a.upper - a.lower) / 2 : a.lower;
    upper_[a.cell + margin_] = a.upper;
  }
}

void GridBlock::start_from(std::span<const double> attained, double tolerance) {
  const double gap = tolerance / 4;  // by which bounds are guessed
  for (std::uint32_t cell : cells_) {
    const double bound = attained[product_.state(Product::Compact{cell, task_}).index];
    lower_[cell + margin_] = !is_probability(measure_) ? bound / (1 + gap) : bound > 0 ? bound + gap : 0;
  }
  started_ = true;
}

void GridBlock::start_from_nothing(bool guess) {
  for (std::uint32_t cell : cells_) lower_[cell + margin_] = 0;
  if (guess && measure_ == Measure::MinCost) guess_costs();
}

// Cells of so many layers of distance as a sweep carries news through. (Counted where the upper bounds will stand.)
std::size_t GridBlock::chunk_size() {
  constexpr std::size_t layers_of_a_chunk = 4, smallest = 64;
  for (std::uint32_t cell : cells_) upper_[cell + margin_] = 0;
  double deepest = 1;
  for (std::uint32_t cell : cells_) {
    double depth = INFINITY;
    for (std::uint32_t d = 0; d < 4; ++d) {
      const std::uint32_t to = product_.model().move(cell, d);
      if (unknown_[to] && upper_[to + margin_] > 0) depth = std::min(depth, upper_[to + margin_]);
    }
    upper_[cell + margin_] = depth < INFINITY ? depth + 1 : 1;
    deepest = std::max(deepest, upper_[cell + margin_]);
  }
  return std::max(smallest, layers_of_a_chunk * cells_.size() / static_cast<std::size_t>(deepest));
}

// The chunks, and which go together: those with cells side by side.
void GridBlock::make_chunks() {
  if (chunk_size_ != 0) return;
  chunk_size_ = chunk_size();
  reach_ = ChunkReach((cells_.size() + chunk_size_ - 1) / chunk_size_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::size_t chunk = i / chunk_size_;
    upper_[cells_[i] + margin_] = static_cast<double>(chunk);
  }
  for (std::size_t i = 0; i < cells_.size(); ++i)
    for (std::uint32_t d = 0; d < 4; ++d)
      if (const std::uint32_t to = product_.model().move(cells_[i], d); unknown_[to])
        reach_.relate(i / chunk_size_, static_cast<std::size_t>(upper_[to + margin_]));
}

// The greatest change: absolute for probabilities; for costs see moves_of_a_change.
double GridBlock::sweep(std::size_t chunk, double over_relaxation) {
  const auto& costs = product_.model().shape().cost;
  const double least = *std::min_element(costs.begin(), costs.end());
  const double most = least > 0 ? moves_of_a_change * least : INFINITY;
  double change = 0;
  for (std::size_t i = chunk * chunk_size_; i < chunk_end(chunk); ++i) {
    const std::uint32_t cell = cells_[i];
    double& value = lower_[cell + margin_];
    const double now = best(cell, lower_), step = now - value;
    change =
        std::max(change, is_probability(measure_) ? std::abs(step) : std::abs(step) / std::min(std::abs(now), most));
    value += over_relaxation * step;
  }
  return change;
}

// Sweeps of the cells between two fronts, then of all of them. Behind the first front they have settled; the second
// moves on by some chunks a sweep, as fast as news travels, since before that a sweep changes little for good.
bool GridBlock::refine(double change, const IterationOptions& options) {
  constexpr std::uint64_t patience = 64;  // sweeps in which nothing settles until over-relaxation is given up
  make_chunks();
  set_around(Side::Middle);
  const std::size_t chunks = reach_.chunks();
  const auto out_of_limits = [&] { return sweeps_ > options.sweeps || options.stop.stop_requested(); };
  double reached = chunks_a_sweep_, factor = over_relaxation_;
  std::uint64_t swept = 0;  // cells
  std::size_t waited = 0;
  bool fronts = true, settled = false;
  const auto between = [&](std::size_t first) {
    return Pass{first, std::clamp(static_cast<std::size_t>(reached), first + 1, chunks), factor};
  };
  const auto work = [&](std::size_t chunk, const Pass& pass) { return sweep(chunk, pass.factor) <= change; };
  const auto after_all = [&](const Pass& pass, std::size_t unsettled) -> std::optional<Pass> {
    ++sweeps_;
    settled = unsettled == pass.end;
    if (settled || out_of_limits()) return std::nullopt;
    return pass;
  };
  const auto after = [&](const Pass& pass, std::size_t unsettled) -> std::optional<Pass> {
    if (!fronts) return after_all(pass, unsettled);
    if (unsettled > pass.begin) waited = 0;
    for (swept += (pass.end - pass.begin) * chunk_size_; swept > cells_.size(); swept -= cells_.size()) ++sweeps_;
    if (waited++ > patience) factor = 1;
    if (out_of_limits()) return std::nullopt;
    reached += chunks_a_sweep_;
    fronts = unsettled < chunks;
    return fronts ? between(unsettled) : Pass{0, chunks};
  };
  pipelined_passes(reach_, options.sweepers.free(), between(0), work, after);
  return settled;
}

// A quarter of the tolerance below and above what sweeps came to.
void GridBlock::guess(double tolerance) {
  const double gap = tolerance / 4;
  for (std::uint32_t cell : cells_) {
    double& lower = lower_[cell + margin_];
    upper_[cell + margin_] = is_probability(measure_) ? std::min(1.0, lower + gap) : lower * (1 + gap);
    lower = is_probability(measure_) ? std::max(0.0, lower - gap) : lower * (1 - gap);
  }
}

bool GridBlock::close_from_above(std::size_t chunk) {
  bool inductive = true;
  for (std::size_t i = chunk * chunk_size_; i < chunk_end(chunk); ++i) {
    double& value = upper_[cells_[i] + margin_];
    const double now = best(cells_[i], upper_);
    inductive = inductive && (!raises(value, now) || (is_probability(measure_) && value == 1));
    value = std::min(value, now);
  }
  return inductive;
}

bool GridBlock::close_from_below(std::size_t chunk) {
  bool inductive = true;
  for (std::size_t i = chunk * chunk_size_; i < chunk_end(chunk); ++i) {
    double& value = lower_[cells_[i] + margin_];
    const double now = best(cells_[i], lower_);
    inductive = inductive && !raises(now, value);
    value = std::min(value, now);
  }
  return inductive;
}

// Sweeps until one finds all values inductive: at most so many.
template <class Close>
bool GridBlock::close(const Close& close_chunk, std::uint64_t most, const IterationOptions& options) {
  bool inductive = false;
  const auto after = [&, tries = std::uint64_t{0}](const Pass& pass, std::size_t unsettled) mutable {
    ++sweeps_;
    inductive = unsettled == pass.end;
    return inductive || ++tries == most ? std::nullopt : std::optional(pass);
  };
  const auto work = [&](std::size_t chunk, const Pass&) { return close_chunk(chunk); };
  pipelined_passes(reach_, options.sweepers.free(), {0, reach_.chunks()}, work, after);
  return inductive;
}

bool GridBlock::prove(std::uint64_t sweeps, const IterationOptions& options) {
  constexpr std::uint64_t some_tries = 16;
  const std::uint64_t most = sweeps / 2 + some_tries;
  set_around(Side::Bounds);
  return close([this](std::size_t chunk) { return close_from_above(chunk); }, most, options) &&
         close([this](std::size_t chunk) { return close_from_below(chunk); }, most, options);
}

// Much finer than the tolerance asks for: guesses are proved in a few sweeps then, or not at all. From what is claimed
// or guessed first, by over-relaxation; where that comes to nothing, as value iteration goes about it.
// No run comes to more than the most that is known around: that bounds them all. Values of passages that are crossed
// several times are that small, and their own bounds would take longest.
bool GridBlock::bound_by_around(double tolerance) {
  double most = 0;
  for (const Around& a : around_) most = std::max(most, a.upper);
  if (!is_probability(measure_) || most > tolerance / 2) return false;
  for (std::uint32_t cell : cells_) lower_[cell + margin_] = 0, upper_[cell + margin_] = most;
  return true;
}

std::optional<std::uint64_t> GridBlock::solve(const IterationOptions& options) {
  if (bound_by_around(options.tolerance)) return sweeps_;
  for (const bool boldly : {true, false}) {
    if (!boldly || !started_) start_from_nothing(boldly);
    const bool from_guess = measure_ == Measure::MinCost && boldly && !started_;
    over_relaxation_ = boldly ? over_relaxation() : 1;
    chunks_a_sweep_ = from_guess ? 1 : 0.5;
    switch (iterate_optimistically(*this, options, options.tolerance / 8192)) {
      case IterationEnd::Proved: return sweeps_;
      case IterationEnd::OutOfLimits: return std::nullopt;
      case IterationEnd::NotProved: break;
    }
  }
  return std::nullopt;
}

}  // namespace waymark::plan
