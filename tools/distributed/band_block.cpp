#include "tools/distributed/band_block.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>

#include "libplan/solve/guessed_steps.hpp"

namespace waymark::tools {

BandBlock::BandBlock(const BandProduct& product, const BandSets& sets, SharedMeasure measure, double discount,
                     std::uint32_t first, std::uint32_t last)
    : product_(&product), measure_(measure), first_(first), last_(last), pairs_(sets.unknowns(first, last)) {
  for (std::uint32_t q = first; q < last; ++q) jumps_ = jumps_ || !product.task().jumps(q).empty();
  read(sets);
  tabulate(discount);
  find_readers();
  double likely = 0;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const GridBand& band = product.band();
    step_ = std::max(step_,
                     plan::guessed_step(is_cost() ? band.cost(k) : 1, band.chance(k, k), band.chance(k, (k + 2) % 4)));
    likely = std::max(likely, band.chance(k, k));
  }
  over_relaxation_ = plan::over_relaxation_of(likely);
}

void BandBlock::read(const BandSets& sets) {
  around_.resize(pairs_.size());
  code_.resize(pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) code_[i] = code(pairs_[i], around_[i], sets);
}

void BandBlock::sort_by(const double* values) {
  std::vector<std::uint32_t> order(pairs_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return values[pairs_[a]] < values[pairs_[b]]; });
  const auto sorted = [&](auto& list) {
    std::remove_reference_t<decltype(list)> out;
    out.reserve(list.size());
    for (const std::uint32_t i : order) out.push_back(list[i]);
    list.swap(out);
  };
  sorted(pairs_);
  sorted(around_);
  sorted(code_);
  find_readers();
  double depth = 0;  // what has no way comes last, with the others there
  for (std::size_t c = 0; c < depth_.size(); ++c) {
    if (const double value = values[pairs_[c * chunk_size]]; !std::isinf(value)) depth = value;
    depth_[c] = depth;
  }
}

// Where costs are asked for, choices count that never leave the unknowns and targets.
std::uint8_t BandBlock::code(std::uint32_t pair, std::array<std::uint32_t, 4>& to, const BandSets& sets) const {
  const auto around = product_->around(pair);
  std::uint32_t away = 0, good = 0, out = 0;
  for (std::uint32_t d = 0; d < 4; ++d) {
    const std::uint32_t t = around.to[d];
    to[d] = t == BandProduct::trap ? product_->pairs() : t;
    if (t != pair) away |= 1U << d;
    if (t != BandProduct::trap && (sets.is_unknown(t) || sets.is_target(t))) good |= 1U << d;
  }
  for (std::uint32_t k = 0; k < 4; ++k)
    if (!is_cost() || (product_->directions(k) & ~good) == 0) out |= 16U << k;
  return static_cast<std::uint8_t>(out | away);
}

// A choice that may come to nothing is taken until it comes to something: divided by the chance that it does.
void BandBlock::tabulate(double discount) {
  const double never = is_cost() ? INFINITY : -1;
  rows_.resize(256);
  for (std::uint32_t code = 0; code < 256; ++code)
    for (std::uint32_t k = 0; k < 4; ++k) {
      const GridBand& band = product_->band();
      double leaves = 0, stays = 0;
      for (std::uint32_t d = 0; d < 4; ++d) (((code >> d) & 1U) != 0 ? leaves : stays) += band.chance(k, d);
      const bool counts = ((code >> (4 + k)) & 1U) != 0 && leaves > 1e-12;
      const double ends = discount == 1 ? leaves : (1 - discount * stays) / discount;
      for (std::uint32_t d = 0; d < 4; ++d)
        rows_[code].chance[d][k] = counts && ((code >> d) & 1U) != 0 ? band.chance(k, d) / ends : 0;
      rows_[code].cost[k] = counts ? (is_cost() ? band.cost(k) / leaves : 0) : never;
    }
}

void BandBlock::find_readers() {
  constexpr std::uint32_t none = UINT32_MAX;
  const std::size_t chunks = (pairs_.size() + chunk_size - 1) / chunk_size;
  const std::uint32_t base = product_->number(0, first_), end = product_->number(0, last_);
  std::vector<std::uint32_t> chunk_of(end - base, none);
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    chunk_of[pairs_[i] - base] = static_cast<std::uint32_t>(i / chunk_size);
  readers_.assign(chunks, {});
  halo_.clear();
  halo_readers_.clear();
  first_reader_.clear();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> halo_reads;  // pair, chunk
  dirty_.assign(chunks, 1);
  depth_.assign(chunks, 0);
  for (std::uint32_t c = 0; c < chunks; ++c) {
    const auto add_to = [&](std::vector<std::uint32_t>& list) {
      if (list.empty() || list.back() != c) list.push_back(c);
    };
    const auto reads = [&](std::uint32_t pair) {
      if (pair < base || pair >= end) return;
      if (!product_->band().is_own(product_->place(pair))) {
        halo_reads.emplace_back(pair, c);
      } else if (chunk_of[pair - base] != none) {
        add_to(readers_[chunk_of[pair - base]]);
      }
    };
    for (std::size_t i = c * chunk_size; i < std::min(pairs_.size(), (c + 1) * chunk_size); ++i) {
      for (const std::uint32_t to : around_[i]) reads(to);
      for (const std::uint32_t q : product_->jumps(pairs_[i])) reads(product_->number(product_->place(pairs_[i]), q));
    }
  }
  std::sort(halo_reads.begin(), halo_reads.end());
  halo_reads.erase(std::unique(halo_reads.begin(), halo_reads.end()), halo_reads.end());
  for (const auto& [pair, chunk] : halo_reads) {
    if (halo_.empty() || halo_.back() != pair) {
      halo_.push_back(pair);
      first_reader_.push_back(static_cast<std::uint32_t>(halo_readers_.size()));
    }
    halo_readers_.push_back(chunk);
  }
  first_reader_.push_back(static_cast<std::uint32_t>(halo_readers_.size()));
  halo_values_.assign(halo_.size(), 0);
}

void BandBlock::touch_all() { std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{1}); }

void BandBlock::touch(const double* values, SweepKind kind, double least) {
  for (std::size_t i = 0; i < halo_.size(); ++i) {
    if (!(difference(halo_values_[i], values[halo_[i]], kind) > least)) continue;
    halo_values_[i] = values[halo_[i]];
    for (std::uint32_t r = first_reader_[i]; r < first_reader_[i + 1]; ++r) dirty_[halo_readers_[r]] = 1;
  }
}

bool BandBlock::has_work(double front) const {
  for (std::size_t c = 0; c < dirty_.size(); ++c)
    if (dirty_[c] != 0 && depth_[c] <= front) return true;
  return false;
}

// Absolute for probabilities; of discounted rewards, which may be as small as γⁿ, relative; of costs, and of
// ways, see plan::moves_of_a_change.
double BandBlock::difference(double before, double after, SweepKind kind) const {
  if (before == after) return 0;
  const double change = std::abs(after - before);
  if (std::isinf(change)) return change;
  if (is_cost() || kind == SweepKind::Distance)
    return change / std::min(std::max(before, after), step_ > 0 ? plan::moves_of_a_change * step_ : INFINITY);
  return measure_ == SharedMeasure::Discounted ? change / std::max(before, after) : change;
}

inline double BandBlock::best(std::size_t unknown, const double* values) const {
  const Row& row = rows_[code_[unknown]];
  const std::array<std::uint32_t, 4>& to = around_[unknown];
  std::array<double, 4> offered = row.cost;
  for (std::size_t d = 0; d < 4; ++d)
    for (std::size_t k = 0; k < 4; ++k) offered[k] += row.chance[d][k] * values[to[d]];
  if (is_cost()) return std::min(std::min(offered[0], offered[1]), std::min(offered[2], offered[3]));
  double found = std::max(std::max(offered[0], offered[1]), std::max(offered[2], offered[3]));
  if (jumps_)
    for (const std::uint32_t q : product_->jumps(pairs_[unknown]))
      found = std::max(found, values[product_->number(product_->place(pairs_[unknown]), q)]);
  return std::max(found, 0.0);
}

inline double BandBlock::nearest(std::size_t unknown, const double* values) const {
  double least = INFINITY;
  for (std::uint32_t k = 0; k < 4; ++k)
    for (std::uint32_t d = 0; d < 4 && ((code_[unknown] >> (4 + k)) & 1U) != 0; ++d)
      if (((product_->directions(k) & code_[unknown]) >> d & 1U) != 0)
        least = std::min(least, step_ + values[around_[unknown][d]]);
  return least;
}

namespace {

// What a sweep makes of a value, given what the operator makes of it; `fails`: whether it shows that a candidate is
// none.
double swept(SweepKind kind, double value, double found, bool& fails) {
  const bool raised = plan::raises(value, found), lowered = plan::raises(found, value);
  switch (kind) {
    case SweepKind::Distance: return std::min(value, found);
    case SweepKind::Below: return std::max(value, found);
    case SweepKind::Free: return found;
    case SweepKind::FromAbove: fails = fails || raised; return raised ? found : std::min(value, found);
    case SweepKind::FromBelow: fails = fails || lowered; return lowered ? found : std::max(value, found);
  }
  return value;
}

}  // namespace

SweepResult BandBlock::sweep(double* values, SweepKind kind, double least, double front) {
  SweepResult result;
  for (std::size_t c = 0; c < dirty_.size(); ++c) {
    if (dirty_[c] == 0 || depth_[c] > front) continue;
    dirty_[c] = 0;
    double change = 0;
    const std::size_t begin = c * chunk_size, end = std::min(pairs_.size(), begin + chunk_size);
    for (std::size_t i = begin; i < end; ++i) {
      double& value = values[pairs_[i]];
      const double found = kind == SweepKind::Distance ? nearest(i, values) : best(i, values);
      const double next = swept(kind, value, found, result.failed);
      if (kind == SweepKind::Free) {
        change = std::max(change, difference(value, next, kind));
        value += over_relaxation_ * (next - value);
        continue;
      }
      if (next == value) continue;
      // A rise that is no more than the rounding of a sum is none: sweeps would go on for it.
      if (kind != SweepKind::Below || plan::raises(value, next))
        change = std::max(change, difference(value, next, kind));
      value = next;
    }
    result.updates += end - begin;
    result.change = std::max(result.change, change);
    if (change > least)
      for (const std::uint32_t reader : readers_[c]) dirty_[reader] = 1;
  }
  return result;
}

}  // namespace waymark::tools
