#include "libparser/model/weight_table.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace waymark::parser {

std::uint16_t half_of(float value) {
  constexpr float most = 65'504.0F;
  return Eigen::half_impl::float_to_half_rtne(std::clamp(value, -most, most)).x;
}

float float_of(std::uint16_t half) {
  return Eigen::half_impl::half_to_float(Eigen::half_impl::raw_uint16_to_half(half));
}

namespace {

// std::lower_bound without branches that cannot be foretold.
std::size_t first_not_less(std::span<const std::uint64_t> sorted, std::uint64_t value) {
  if (sorted.empty()) return 0;
  const std::uint64_t* from = sorted.data();
  for (std::size_t n = sorted.size(); n > 1;) {
    const std::size_t half = n / 2;
    from += from[half - 1] < value ? half : 0;
    n -= half;
  }
  return static_cast<std::size_t>(from - sorted.data()) + (*from < value ? 1 : 0);
}

}  // namespace

// Where the feature stands, or the empty slot where it would.
std::size_t WeightTable::slot_of(std::uint64_t feature) const {
  std::uint64_t hash = (feature ^ feature >> 31U) * 0x9E3779B97F4A7C15ULL;
  hash ^= hash >> 32U;
  std::size_t slot = hash & (slots_.size() - 1);
  while (slots_[slot] != empty && keys_[slots_[slot]] != feature) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

std::optional<WeightRow> WeightTable::find(std::uint64_t feature) const {
  std::size_t anywhere = 0;
  return find(feature, anywhere);
}

std::optional<WeightRow> WeightTable::find(std::uint64_t feature, std::size_t& near) const {
  if (is_stored()) return find_stored(feature, near);
  const std::uint32_t row = slots_[slot_of(feature)];
  return row == empty ? std::nullopt : std::optional(WeightRow{row});
}

// A row is told by where its weights begin among the bytes. A few blocks from
// `near` on are tried one by one.
std::optional<WeightRow> WeightTable::find_stored(std::uint64_t feature, std::size_t& near) const {
  constexpr std::size_t tried = 4;
  const std::span<const std::uint64_t> last = stored_.last;
  std::size_t b = near > 0 && last[near - 1] >= feature ? 0 : near;
  const std::size_t stop = std::min(b + tried, last.size());
  while (b < stop && last[b] < feature) ++b;
  if (b == stop) b += first_not_less(last.subspan(b), feature);
  if (b == last.size()) return std::nullopt;
  near = b;
  const char* at = stored_.bytes.data() + (b > 0 ? stored_.end[b - 1] : 0);
  for (std::uint64_t here = b > 0 ? last[b - 1] : 0;;) {
    here += take_leb128(at);
    if (here == feature) return WeightRow{static_cast<std::uint32_t>(at - stored_.bytes.data())};
    if (here > feature) return std::nullopt;
    at = each_weight(at, [](std::size_t, std::uint16_t) {});
  }
}

WeightRow WeightTable::add(std::uint64_t feature) {
  assert(!is_stored());
  const std::size_t slot = slot_of(feature);
  if (slots_[slot] != empty) return {slots_[slot]};
  const auto row = static_cast<std::uint32_t>(keys_.size());
  slots_[slot] = row;
  keys_.push_back(feature);
  weights_.resize(weights_.size() + columns_, 0.0F);
  if (2 * keys_.size() > slots_.size()) {
    slots_.assign(4 * slots_.size(), empty);
    for (std::uint32_t r = 0; r < keys_.size(); ++r) slots_[slot_of(keys_[r])] = r;
  }
  return {row};
}

float WeightTable::weight(WeightRow r, std::size_t column) const {
  if (!is_stored()) return weights_[r.index * columns_ + column];
  float found = 0;
  each_weight(stored_.bytes.data() + r.index, [&](std::size_t c, std::uint16_t half) {
    if (c == column) found = float_of(half);
  });
  return found;
}

void WeightTable::add_to(WeightRow r, float* sums) const {
  if (is_stored()) {
    each_weight(stored_.bytes.data() + r.index, [&](std::size_t c, std::uint16_t half) { sums[c] += float_of(half); });
    return;
  }
  const float* const row = weights_.data() + r.index * columns_;
  for (std::size_t c = 0; c < columns_; ++c) sums[c] += row[c];
}

}  // namespace waymark::parser
