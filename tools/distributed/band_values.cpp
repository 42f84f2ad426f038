#include "tools/distributed/band_values.hpp"

#include <algorithm>
#include <cmath>

namespace waymark::tools {
namespace {

constexpr double coarsest = 1e-2;             // as in libplan/solve/decide.cpp
constexpr std::uint64_t fewest_rounds = 100;  // of a proof
constexpr double layers_a_sweep = 4;          // of unknowns, by which a front moves on

class Lap {  // adds the seconds of its life
 public:
  explicit Lap(double& seconds) : seconds_(seconds) {}
  ~Lap() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  Lap(const Lap&) = delete;
  Lap& operator=(const Lap&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

BandValues::BandValues(const Ranks& ranks, const BandProduct& product, const BandSets& sets, SharedMeasure measure,
                       const SharedOptions& options, const KeptBands* kept)
    : ranks_(&ranks),
      product_(&product),
      sets_(&sets),
      measure_(measure),
      options_(options),
      kept_(kept),
      tolerance_(options.tolerance) {
  static_assert(plan::OptimisticBackend<BandValues>);
  for (Vec* vector : {&lower_vector_, &upper_vector_})
    check(VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(product.pairs()) + 1, vector));
  check(VecGetArray(lower_vector_, &lower_));
  check(VecGetArray(upper_vector_, &upper_));
  const double of_target = is_cost() ? 0 : measure == SharedMeasure::Discounted ? 1 / options.discount : 1;
  for (std::uint32_t pair = 0; pair <= product.pairs(); ++pair)
    lower_[pair] = upper_[pair] = pair < product.pairs() && sets.is_target(pair) ? of_target : 0;
  product.for_each_own([&](std::uint32_t pair) { statistics_.pairs += sets.is_reached(pair) ? 1 : 0; });
}

BandValues::~BandValues() {
  VecRestoreArray(lower_vector_, &lower_);
  VecRestoreArray(upper_vector_, &upper_);
  VecDestroy(&lower_vector_);
  VecDestroy(&upper_vector_);
}

void BandValues::fetch(double* values) {
  const Lap lap(statistics_.exchanging);
  halo_->fetch(values + product_->number(0, component_.first));
  statistics_.values += halo_->values();
}

std::span<double> BandValues::own(double* values, std::uint32_t state) const {
  const GridBand& band = product_->band();
  return {values + product_->number(band.first_own(), state), band.last_own() - band.first_own()};
}

bool BandValues::solve() {
  const std::vector<std::uint32_t>& components = product_->task().components();
  std::uint32_t planes = 0;
  for (std::size_t c = 0; c + 1 < components.size(); ++c) {
    component_ = {components[c], components[c + 1]};
    if (const std::uint32_t count = component_.last - component_.first; count != planes) {
      halo_ = std::make_unique<Halo>(*ranks_, product_->band(), count);
      planes = count;
    }
    if (!solve_component(c)) return false;
    proved_ = component_.last;
  }
  return true;
}

// Bounds of the states that components lead into are `share_` apart when this one begins.
bool BandValues::solve_component(std::size_t among) {
  const double discount = measure_ == SharedMeasure::Discounted ? options_.discount : 1;
  block_ = std::make_unique<BandBlock>(*product_, *sets_, measure_, discount, component_.first, component_.last);
  front_ = INFINITY;
  deepest_ = 0;
  statistics_.unknowns += block_->unknowns().size();
  if (!ranks_->any(!block_->unknowns().empty())) return true;
  if (kept_ != nullptr && find_kept()) {
    ++statistics_.resumed;
    end_component();
    return true;
  }
  if (!(is_cost() ? start_costs() : start_front())) return false;
  for (;; tolerance_ *= 10) {
    own_share_ = tolerance_ / static_cast<double>(product_->task().components().size() - 1);
    share_ = own_share_ * static_cast<double>(among + 1);
    const double change = is_cost() ? own_share_ / 8192 : share_ / 64;
    const auto end = plan::iterate_optimistically(*this, {.tolerance = share_}, change);
    if (end == plan::IterationEnd::Proved) break;
    if (stopped_ || tolerance_ >= coarsest) return false;
  }
  end_component();
  if (kept_ == nullptr) return true;
  for (std::uint32_t q = component_.first; q < component_.last; ++q)
    kept_->keep_proved(q, own(lower_, q), own(upper_, q));
  ++statistics_.checkpoints;
  kept_at_ = Clock::now();
  return true;
}

void BandValues::end_component() {
  fetch(lower_);
  fetch(upper_);
}

// True: all ranks have proved bounds. Else lower bounds begin where they were.
bool BandValues::find_kept() {
  bool all = true;
  for (std::uint32_t q = component_.first; q < component_.last; ++q) {
    std::vector<double> lower(own(lower_, q).begin(), own(lower_, q).end()), upper(lower.size());
    const bool found = kept_->find_proved(q, lower, upper);
    if (found) std::copy(upper.begin(), upper.end(), own(upper_, q).begin());
    if (!found) kept_->find_values(q, lower);
    std::copy(lower.begin(), lower.end(), own(lower_, q).begin());
    all = all && found;
  }
  return !ranks_->any(!all);
}

void BandValues::keep_values() {
  for (std::uint32_t q = component_.first; q < component_.last; ++q) kept_->keep_values(q, own(lower_, q));
  ++statistics_.checkpoints;
  kept_at_ = Clock::now();
}

// An exchange, and the sweeps until the next one.
SweepResult BandValues::sweep(double* values, SweepKind kind, double least) {
  fetch(values);
  const Lap lap(statistics_.sweeping);
  SweepResult all;
  block_->touch(values, kind, least);
  for (std::uint32_t i = 0; i < options_.local_sweeps; ++i) {
    front_ += layers_a_sweep * block_->step();
    if (!block_->has_work(front_)) continue;
    const SweepResult result = block_->sweep(values, kind, least, front_);
    all.change = std::max(all.change, result.change);
    all.failed = all.failed || result.failed;
    all.updates += result.updates;
  }
  statistics_.updates += all.updates;
  return all;
}

BandValues::Told BandValues::agree(const SweepResult& own) {
  const bool due = kept_ != nullptr && ranks_->rank() == 0 &&
                   std::chrono::duration<double>(Clock::now() - kept_at_).count() >= options_.checkpoint_seconds;
  std::array<double, 5> told{own.change, own.failed ? 1.0 : 0.0, options_.stop.stop_requested() ? 1.0 : 0.0,
                             due ? 1.0 : 0.0, static_cast<double>(own.updates)};
  {
    const Lap lap(statistics_.agreeing);
    ranks_->greatest_of_each(told);
  }
  ++statistics_.rounds;
  statistics_.longest += static_cast<std::uint64_t>(told[4]);
  if (told[3] != 0) keep_values();
  stopped_ = told[2] != 0;
  return {told[0], told[1] != 0, stopped_};
}

// Over-relaxation is given up when it comes to nothing: when changes have not become smaller for a while.
bool BandValues::refine(double* values, SweepKind kind, double change) {
  constexpr int patience = 64;
  double least = INFINITY;
  int waited = 0;
  block_->touch_all();
  while (true) {
    const Told told = agree(sweep(values, kind, change));
    if (told.stop) return false;
    if (front_ < deepest_) continue;
    if (!(told.change > change)) return true;
    waited = told.change < least ? 0 : waited + 1;
    least = std::min(least, told.change);
    if (waited == patience) block_->relax_no_more();
  }
}

// What is better said of costs than nothing: the least way, if every move went where one would wish, times what a move
// gets on by against its slips. Where all ranks have costs that were kept, sweeps go on from them.
bool BandValues::start_costs() {
  const std::vector<std::uint32_t>& pairs = block_->unknowns();
  const auto is_new = [&](std::uint32_t pair) { return lower_[pair] == 0 || std::isinf(lower_[pair]); };
  if (!ranks_->any(std::any_of(pairs.begin(), pairs.end(), is_new))) return true;
  for (const std::uint32_t pair : pairs) lower_[pair] = INFINITY;
  return find_ways(lower_);
}

// Of probabilities and discounted rewards: how far each unknown is from what is known to be worth something.
bool BandValues::start_front() {
  std::vector<double> ways(product_->pairs() + 1, INFINITY);
  for (std::uint32_t pair = 0; pair < product_->pairs(); ++pair)
    if (lower_[pair] > 0) ways[pair] = 0;
  for (const std::uint32_t pair : block_->unknowns()) ways[pair] = INFINITY;
  return find_ways(ways.data());
}

// The unknowns by their least ways to what is known, and a front that begins at the nearest ones.
bool BandValues::find_ways(double* ways) {
  constexpr double some_steps = 1.0 / 64;  // exact ones may change sides at every step, which would take long
  if (!refine(ways, SweepKind::Distance, some_steps)) return false;
  block_->sort_by(ways);
  front_ = block_->step() > 0 ? ranks_->least(block_->nearest()) : INFINITY;  // else it would not move on
  deepest_ = ranks_->greatest(block_->deepest());
  return true;
}

bool BandValues::refine(double change, const plan::IterationOptions&) {
  return refine(lower_, is_cost() ? SweepKind::Free : SweepKind::Below, change);
}

// Known bounds are no further apart than the share of the components before.
void BandValues::guess(double) {
  const double before = share_ - own_share_;
  for (const std::uint32_t pair : block_->unknowns()) {
    const double value = lower_[pair];
    upper_[pair] = is_cost() ? value * (1 + before + own_share_ / 2) : std::min(1.0, value + before + own_share_ / 2);
    if (is_cost()) lower_[pair] = value / (1 + own_share_ / 4);
  }
}

bool BandValues::prove(std::uint64_t sweeps, const plan::IterationOptions& options) {
  const auto close = [&](double* values, SweepKind kind) {
    block_->touch_all();
    for (std::uint64_t i = 0; i < std::max(sweeps, fewest_rounds); ++i) {
      const Told told = agree(sweep(values, kind, 0));
      if (told.stop || !told.failed) return !told.stop;
    }
    return false;
  };
  if (!close(upper_, SweepKind::FromAbove) || (is_cost() && !close(lower_, SweepKind::FromBelow))) return false;
  double gap = 0;
  for (const std::uint32_t pair : block_->unknowns())
    gap = std::max(gap, (upper_[pair] - lower_[pair]) / (is_cost() ? lower_[pair] : 1));
  return ranks_->greatest(gap) <= options.tolerance;
}

plan::Bounds BandValues::bounds(std::uint32_t pair) const {
  if (sets_->is_target(pair)) return is_cost() ? plan::Bounds{0, 0} : plan::Bounds{1, 1};
  if (!sets_->is_unknown(pair)) return is_cost() ? plan::Bounds{INFINITY, INFINITY} : plan::Bounds{0, 0};
  const bool proved = product_->state(pair) < proved_;
  if (!proved) return is_cost() ? plan::Bounds{0, INFINITY} : plan::Bounds{lower_[pair], 1};
  return {lower_[pair], upper_[pair]};
}

plan::Bounds BandValues::value() const {
  const bool least = is_cost();
  plan::Bounds best = least ? plan::Bounds{INFINITY, INFINITY} : plan::Bounds{0, 0};
  for (const std::uint32_t pair : sets_->starts()) {
    const plan::Bounds found = bounds(pair);
    best.lower = least ? std::min(best.lower, found.lower) : std::max(best.lower, found.lower);
    best.upper = least ? std::min(best.upper, found.upper) : std::max(best.upper, found.upper);
  }
  return least ? plan::Bounds{ranks_->least(best.lower), ranks_->least(best.upper)}
               : plan::Bounds{ranks_->greatest(best.lower), ranks_->greatest(best.upper)};
}

}  // namespace waymark::tools
