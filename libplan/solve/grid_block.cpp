#include "libplan/solve/grid_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "libplan/solve/guessed_steps.hpp"

namespace waymark::plan {

GridBlock::GridBlock(const Product& product, Measure measure, const Order& order, const Strategy* only,
                     std::pmr::memory_resource* memory)
    : product_(product),
      measure_(measure),
      only_(only),
      task_(order.states.front().task),
      strips_(product.model(), order.states, order.chunk_size()),
      chunk_size_(order.chunk_size()),
      code_(strips_.slots()),
      marks_(strips_.slots()),
      lower_(memory),
      upper_(memory) {
  strips_.for_each_slot([&](std::uint32_t slot) { marks_[slot] = unknown; });
  strips_.exchange().for_each([&](std::uint32_t, std::uint32_t slot) { marks_[slot] = copy; });
}

std::optional<GridBlock> GridBlock::of(const Product& product, const Unknowns& unknowns, Measure measure, Order order,
                                       const Strategy* only, std::pmr::memory_resource* memory) {
  const std::uint32_t task = order.states.front().task;
  if (!product.task().jumps(task).empty()) return std::nullopt;
  for (const auto& c : order.states) {
    const bool merged = unknowns.merged.count > 0 && unknowns.merged.of[product.state(c).index] != EndComponents::none;
    if (merged || c.task != task) return std::nullopt;
  }
  GridBlock block(product, measure, order, only, memory);
  std::vector<Product::Compact>().swap(order.states);  // its memory is that of what follows
  if (!block.read(unknowns)) return std::nullopt;
  block.tabulate();
  block.lower_.assign(block.strips_.slots(), 0);
  block.upper_.assign(block.strips_.slots(), 0);
  return block;
}

// The chance that a choice leads in a direction when nothing is barred.
double GridBlock::chance(std::uint32_t choice, std::uint32_t direction) const {
  const SlipChances& slip = product_.model().shape().motion[choice];
  return std::array<double, 4>{slip.forward, slip.right, slip.back, slip.left}[(direction + 4 - choice) % 4];
}

bool GridBlock::read(const Unknowns& unknowns) {
  bool all = true;
  strips_.for_each([&](std::uint32_t cell, std::uint32_t slot) { all = all && read_cell(cell, slot, unknowns); });
  return all;
}

// What its neighbours are, and which choices count. False: not of this kind.
bool GridBlock::read_cell(std::uint32_t cell, std::uint32_t slot, const Unknowns& unknowns) {
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
    const std::uint32_t at = slot + static_cast<std::uint32_t>(strips_.steps()[d]);
    const bool unknown_there = (marks_[at] & (unknown | copy)) != 0;
    if (unknown_there && q != task_) return false;  // met with two tasks
    if (unknown_there) {
      good |= 1U << d;
      continue;
    }
    if (q == TaskTable::trap) continue;
    const std::uint32_t t = product_.state(Product::Compact{to, q}).index;
    if (!unknowns.targets[t] && !unknowns.unknown[t]) continue;
    if (unknowns.unknown[t] && q == task_) return false;
    good |= 1U << d;
    const double target = is_probability(measure_) ? 1 : 0;
    around_.push_back({at, unknowns.targets[t] ? UINT32_MAX : t, target, target});
  }
  std::uint32_t choices = counted(open, good);
  if (only_ != nullptr) choices &= 16U << only_->choice[state(cell)];
  code_[slot] = static_cast<std::uint8_t>(open | choices);
  marks_[slot] |= static_cast<std::uint8_t>(good);
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
  const std::array<std::int32_t, 4>& all = strips_.steps();
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
inline std::array<double, 4> GridBlock::around(std::uint32_t slot, const Values& x) const {
  const double* here = x.data() + slot;
  const std::array<std::int32_t, 4>& to = steps_[code_[slot] & 15U];
  return {here[to[0]], here[to[1]], here[to[2]], here[to[3]]};
}

inline double GridBlock::of_strategy(std::uint32_t slot, const Values& x) const {
  const Only& row = only_rows_[code_[slot]];
  const std::array<double, 4> values = around(slot, x);
  double sum = row.cost;
  for (std::size_t d = 0; d < 4; ++d) sum += row.chance[d] * values[d];
  return sum;
}

inline double GridBlock::best(std::uint32_t slot, const Values& x) const {
  if (only_ != nullptr) return of_strategy(slot, x);
  const Row& row = rows_[code_[slot]];
  const std::array<double, 4> values = around(slot, x);
  std::array<double, 4> offered = row.cost;
  for (std::size_t d = 0; d < 4; ++d)
    for (std::size_t k = 0; k < 4; ++k) offered[k] += row.chance[d][k] * values[d];
  if (measure_ == Measure::MinCost) return std::min(std::min(offered[0], offered[1]), std::min(offered[2], offered[3]));
  return std::max(std::max(std::max(offered[0], offered[1]), std::max(offered[2], offered[3])), 0.0);
}

void GridBlock::know(const KeptBounds& known) {
  for (Around& a : around_)
    if (a.state != UINT32_MAX) a.lower = known.lower(a.state), a.upper = known.upper(a.state);
}

// What is known around the block: the bounds, or what lies between them.
void GridBlock::set_around(Side side) {
  for (const Around& a : around_) {
    lower_[a.slot] = side == Side::Middle ? a.lower + (a.upper - a.lower) / 2 : a.lower;
    upper_[a.slot] = a.upper;
  }
}

void GridBlock::start_from(std::span<const double> attained, double tolerance) {
  const double gap = tolerance / 4;  // by which bounds are guessed
  strips_.for_each([&](std::uint32_t cell, std::uint32_t slot) {
    const double bound = attained[state(cell)];
    lower_[slot] = !is_probability(measure_) ? bound / (1 + gap) : bound > 0 ? bound + gap : 0;
  });
  started_ = true;
}

void GridBlock::start_from_nothing(bool guess) {
  strips_.for_each_slot([&](std::uint32_t slot) { lower_[slot] = 0; });
  if (guess && measure_ == Measure::MinCost) guess_costs();
}

// Passes over `*values`: settles(slots of a chunk in a strip, pass) -> bool; next as in passes_side_by_side.
template <class Settles, class Next>
void GridBlock::run(const Pass& first, Values* const& values, const IterationOptions& options, const Settles& settles,
                    Next next) {
  strips_.exchange().copy(*values);
  const auto work = [&](std::size_t s, const PassInTurn& now) {
    const Pass& pass = now.pass;
    strips_.exchange().take(s, now, *values);
    std::size_t unsettled = pass.end;
    for (std::size_t chunk = pass.begin; chunk < pass.end; ++chunk)
      if (!settles(strips_.chunk(s, chunk), pass)) unsettled = std::min(unsettled, chunk);
    strips_.exchange().tell(s, now, *values);
    return unsettled;
  };
  passes_side_by_side(strips_.count(), options.sweepers.free(), first, work, std::move(next));
}

// The greatest change: absolute for probabilities; for costs see moves_of_a_change.
double GridBlock::sweep(std::span<const std::uint32_t> slots, double over_relaxation) {
  const auto& costs = product_.model().shape().cost;
  const double least = *std::min_element(costs.begin(), costs.end());
  const double most = least > 0 ? moves_of_a_change * least : INFINITY;
  double change = 0;
  for (const std::uint32_t slot : slots) {
    double& value = lower_[slot];
    const double now = best(slot, lower_), step = now - value;
    change =
        std::max(change, is_probability(measure_) ? std::abs(step) : std::abs(step) / std::min(std::abs(now), most));
    value = std::max(0.0, value + over_relaxation * step);  // none is negative, and steps too long would make it so
  }
  return change;
}

// Sweeps of the cells between two fronts, then of all of them. Behind the first front they have settled; the second
// moves on by some chunks a sweep, as fast as news travels, since before that a sweep changes little for good.
bool GridBlock::refine(double change, const IterationOptions& options) {
  constexpr std::uint64_t patience = 64;  // sweeps in which nothing settles until over-relaxation is given up
  set_around(Side::Middle);
  const std::size_t chunks = strips_.chunks();
  struct alignas(64) {  // what changes from pass to pass: a line of the cache of its own
    double reached, factor;
    std::uint64_t sweeps, swept = 0;  // swept: cells
    std::size_t waited = 0;
    bool fronts = true, settled = false;
  } at{chunks_a_sweep_, over_relaxation_, sweeps_};
  const auto out_of_limits = [&] { return at.sweeps > options.sweeps || options.stop.stop_requested(); };
  const auto between = [&](std::size_t first) {
    return Pass{first, std::clamp(static_cast<std::size_t>(at.reached), first + 1, chunks), at.factor};
  };
  const auto settles = [this, change](auto slots, const Pass& pass) { return sweep(slots, pass.factor) <= change; };
  const auto after_all = [&](const Pass& pass, std::size_t unsettled) -> std::optional<Pass> {
    ++at.sweeps;
    at.settled = unsettled == pass.end;
    if (at.settled || out_of_limits()) return std::nullopt;
    return pass;
  };
  const auto after = [&](const Pass& pass, std::size_t unsettled) -> std::optional<Pass> {
    if (!at.fronts) return after_all(pass, unsettled);
    if (unsettled > pass.begin) at.waited = 0;
    for (at.swept += (pass.end - pass.begin) * chunk_size_; at.swept > strips_.cells(); at.swept -= strips_.cells())
      ++at.sweeps;
    if (at.waited++ > patience) at.factor = 1;
    if (out_of_limits()) return std::nullopt;
    at.reached += chunks_a_sweep_;
    at.fronts = unsettled < chunks;
    return at.fronts ? between(unsettled) : Pass{0, chunks};
  };
  run(between(0), &lower_, options, settles, after);
  sweeps_ = at.sweeps;
  return at.settled;
}

// A quarter of the tolerance below and above what sweeps came to.
void GridBlock::guess(std::span<const std::uint32_t> slots) {
  for (const std::uint32_t slot : slots) {
    double& lower = lower_[slot];
    upper_[slot] = is_probability(measure_) ? std::min(1.0, lower + gap_) : lower * (1 + gap_);
    lower = is_probability(measure_) ? std::max(0.0, lower - gap_) : lower * (1 - gap_);
  }
}

bool GridBlock::close_from_above(std::span<const std::uint32_t> slots) {
  bool inductive = true;
  for (const std::uint32_t slot : slots) {
    double& value = upper_[slot];
    const double now = best(slot, upper_);
    inductive = inductive && (!raises(value, now) || (is_probability(measure_) && value == 1));
    value = std::min(value, now);
  }
  return inductive;
}

bool GridBlock::close_from_below(std::span<const std::uint32_t> slots) {
  bool inductive = true;
  for (const std::uint32_t slot : slots) {
    double& value = lower_[slot];
    const double now = best(slot, lower_);
    inductive = inductive && !raises(now, value);
    value = std::min(value, now);
  }
  return inductive;
}

// Guesses, then sweeps until one finds all upper values inductive, then until one finds all lower ones so.
bool GridBlock::prove(std::uint64_t sweeps, const IterationOptions& options) {
  enum class Stage : std::uint8_t { Guess, Above, Below };
  constexpr std::uint64_t some_tries = 16;
  const std::uint64_t most = sweeps / 2 + some_tries;  // of a stage
  bool proved = false;
  Stage stage = Stage::Guess;
  Values* values = &lower_;
  const auto settles = [&](auto slots, const Pass&) {
    if (stage == Stage::Guess) guess(slots);
    return stage == Stage::Guess || (stage == Stage::Above ? close_from_above(slots) : close_from_below(slots));
  };
  const auto begin = [&](Stage next, const Pass& pass) {
    stage = next;
    values = next == Stage::Above ? &upper_ : &lower_;
    strips_.exchange().copy(*values);
    return std::optional(Pass{pass.begin, pass.end, 1, true});
  };
  const auto after = [&, tries = std::uint64_t{0}](const Pass& pass, std::size_t unsettled) mutable {
    if (stage == Stage::Guess) {
      set_around(Side::Bounds);
      return begin(Stage::Above, pass);
    }
    ++sweeps_;
    proved = unsettled == pass.end && stage == Stage::Below;
    if (proved || (unsettled < pass.end && ++tries == most)) return std::optional<Pass>();
    if (unsettled < pass.end) return std::optional(Pass{pass.begin, pass.end});
    tries = 0;
    return begin(Stage::Below, pass);
  };
  run({0, strips_.chunks()}, values, options, settles, after);
  return proved;
}

// No run comes to more than the most that is known around: that bounds them all. Values of passages that are crossed
// several times are that small, and their own bounds would take longest.
bool GridBlock::bound_by_around(double tolerance) {
  double most = 0;
  for (const Around& a : around_) most = std::max(most, a.upper);
  if (!is_probability(measure_) || most > tolerance / 2) return false;
  strips_.for_each_slot([&](std::uint32_t slot) { lower_[slot] = 0, upper_[slot] = most; });
  return true;
}

// Much finer than the tolerance asks for: guesses are proved in a few sweeps then, or not at all. From what is claimed
// or guessed first, by over-relaxation; where that comes to nothing, as value iteration goes about it.
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
