#include "libparser/lifted/formula_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "libparser/lifted/matching_features.hpp"

namespace waymark::parser {

using neural::Index;
using neural::Vector;

namespace {

constexpr std::uint64_t most_features = 1 << 20, most_width = 512, most_known = 1 << 16;

struct OwnedTable {
  std::vector<std::uint64_t> keys;
  std::vector<float> scales;
  std::vector<std::int8_t> entries;
};

}  // namespace

FeatureTable::FeatureTable(std::vector<std::uint64_t> keys, const neural::Matrix& columns) : width_(columns.rows()) {
  auto owned = std::make_shared<OwnedTable>();
  owned->keys = std::move(keys);
  for (Index c = 0; c < columns.cols(); ++c) {
    const float highest = columns.col(c).cwiseAbs().maxCoeff(), scale = highest > 0 ? highest / 127 : 1;
    owned->scales.push_back(scale);
    for (Index r = 0; r < width_; ++r)
      owned->entries.push_back(static_cast<std::int8_t>(std::lround(columns(r, c) / scale)));
  }
  keys_ = owned->keys;
  scales_ = owned->scales;
  entries_ = owned->entries;
  owner_ = std::move(owned);
}

std::size_t FeatureTable::add(std::span<const std::uint64_t> keys, float weight, Eigen::Ref<Vector> sum) const {
  std::size_t known = 0;
  for (const std::uint64_t key : keys) {
    const auto at = std::lower_bound(keys_.begin(), keys_.end(), key);
    if (at == keys_.end() || *at != key) continue;
    ++known;
    const auto c = static_cast<std::size_t>(at - keys_.begin());
    const Eigen::Map<const Eigen::Matrix<std::int8_t, Eigen::Dynamic, 1>> column(
        entries_.data() + c * static_cast<std::size_t>(width_), width_);
    sum += weight * scales_[c] * column.cast<float>();
  }
  return known;
}

void FeatureTable::write(WeightsWriter& out) const {
  out.number(static_cast<std::uint64_t>(width_));
  out.list(keys_);
  out.list(scales_);
  out.list(entries_);
}

FeatureTable FeatureTable::read(WeightsReader& in, const std::shared_ptr<const void>& owner) {
  FeatureTable table;
  const std::uint64_t width = in.number();
  if (width < 1 || width > most_width) in.fail("vectors of features of no possible width");
  table.width_ = static_cast<Index>(width);
  table.owner_ = owner;
  table.keys_ = in.list<std::uint64_t>();
  table.scales_ = in.list<float>();
  table.entries_ = in.list<std::int8_t>();
  const std::size_t n = table.keys_.size();
  if (n > most_features || table.scales_.size() != n || table.entries_.size() != n * width)
    in.fail("a table of features of another size than it says");
  if (!std::is_sorted(table.keys_.begin(), table.keys_.end())) in.fail("features that do not ascend");
  if (!std::all_of(table.scales_.begin(), table.scales_.end(), [](float s) { return s > 0 && std::isfinite(s); }))
    in.fail("a scale that is no positive number");
  return table;
}

LiftedScope needed_scope(std::span<const LiftedSymbol> formula) {
  LiftedScope scope;
  for (const LiftedSymbol s : formula) {
    if (is_slot(s)) scope.slots = std::max(scope.slots, number_of(s));
    if (is_constant(s)) scope.constants = std::max(scope.constants, number_of(s));
    scope.spatial = scope.spatial || is_direction(s) || is_event(s) || is_action(s) || s == LiftedSymbol::StayOn;
  }
  return scope;
}

bool is_within(const LiftedScope& needed, const LiftedScope& scope) {
  return needed.slots <= scope.slots && needed.constants <= scope.constants && (scope.spatial || !needed.spatial);
}

FormulaMatcher::FormulaMatcher(FeatureTable texts, FeatureTable formulas, std::vector<Lifted> known)
    : texts_(std::move(texts)), formulas_(std::move(formulas)), known_(std::move(known)) {
  vectors_.resize(formulas_.width(), static_cast<Index>(known_.size()));
  for (std::size_t i = 0; i < known_.size(); ++i) vectors_.col(static_cast<Index>(i)) = encode(known_[i]);
}

Vector FormulaMatcher::encode(const LiftedText& text) const {
  Vector sum = Vector::Zero(texts_.width());
  const std::size_t known = texts_.add(matching_features(text), 1, sum);
  Vector out(texts_.width() + 1);
  out << (sum / std::sqrt(static_cast<float>(known) + 1)).cwiseMax(0.0F), 1;
  return out;
}

Vector FormulaMatcher::encode(std::span<const LiftedSymbol> formula) const {
  const std::vector<std::uint64_t> features = matching_features(formula);
  Vector sum = Vector::Zero(formulas_.width());
  formulas_.add(features, 1 / std::sqrt(static_cast<float>(features.size())), sum);
  return sum;
}

double FormulaMatcher::score(const Vector& encoded, std::span<const LiftedSymbol> formula) const {
  return static_cast<double>(encoded.dot(encode(formula)));
}

bool FormulaMatcher::knows(const Lifted& formula) const {
  return std::binary_search(known_.begin(), known_.end(), formula);
}

FormulaMatcher::Matches FormulaMatcher::best(const Vector& encoded, const LiftedScope& scope, std::size_t k) const {
  const Vector scores = vectors_.transpose() * encoded;
  std::vector<Match> all;
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < known_.size(); ++i) {
    if (!is_within(needed_scope(known_[i]), scope)) continue;
    all.push_back({&known_[i], static_cast<double>(scores(static_cast<Index>(i)))});
    highest = std::max(highest, all.back().log_probability);
  }
  const double total = std::accumulate(all.begin(), all.end(), 0.0, [&](double sum, const Match& m) {
    return sum + std::exp(m.log_probability - highest);
  });
  const auto likelier = [](const Match& a, const Match& b) { return a.log_probability > b.log_probability; };
  k = std::min(k, all.size());
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k), all.end(), likelier);
  all.resize(k);
  const double log_total = highest + std::log(total);
  for (Match& m : all) m.log_probability -= log_total;
  return {std::move(all), log_total};
}

void FormulaMatcher::write(WeightsWriter& out) const {
  texts_.write(out);
  formulas_.write(out);
  std::vector<std::uint8_t> symbols;
  std::vector<std::uint32_t> ends;
  for (const Lifted& lifted : known_) {
    for (const LiftedSymbol s : lifted) symbols.push_back(static_cast<std::uint8_t>(s));
    ends.push_back(static_cast<std::uint32_t>(symbols.size()));
  }
  out.list(symbols);
  out.list(ends);
}

FormulaMatcher FormulaMatcher::read(WeightsReader& in, const std::shared_ptr<const void>& owner) {
  FeatureTable texts = FeatureTable::read(in, owner), formulas = FeatureTable::read(in, owner);
  if (formulas.width() != texts.width() + 1) in.fail("towers that do not meet");
  const auto symbols = in.list<std::uint8_t>();
  const auto ends = in.list<std::uint32_t>();
  if (ends.size() > most_known) in.fail("more known formulas than there may be");
  std::vector<Lifted> known;
  std::size_t begin = 0;
  const LiftedScope everything{12, 16, true};
  for (const std::uint32_t end : ends) {
    if (end < begin || end > symbols.size()) in.fail("known formulas of no possible length");
    Lifted lifted;
    for (; begin < end; ++begin) {
      if (symbols[begin] >= lifted_symbols) in.fail("a symbol that is none");
      lifted.push_back(static_cast<LiftedSymbol>(symbols[begin]));
    }
    if (!is_spelled_in(lifted, everything)) in.fail("a known formula that is none");
    known.push_back(std::move(lifted));
  }
  if (!std::is_sorted(known.begin(), known.end())) in.fail("known formulas that do not ascend");
  return {std::move(texts), std::move(formulas), std::move(known)};
}

}  // namespace waymark::parser
