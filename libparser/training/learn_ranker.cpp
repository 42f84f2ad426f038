#include "libparser/training/learn_ranker.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "libltl/structure/random.hpp"
#include "libparser/rerank/adagrad.hpp"
#include "libparser/training/training_instance.hpp"

namespace waymark::parser {
namespace {

class RankerLearner {
 public:
  RankerLearner(WeightTable& weights, const RankerOptions& options)
      : weights_(weights),
        optimizer_(weights, options.rate, options.decay, options.first_squares),
        least_error_(static_cast<float>(options.least_error)),
        against_rival_(static_cast<float>(options.against_rival)),
        decay_again_(options.decay_again),
        gradient_(weights.rows(), 0.0F),
        met_(weights.rows(), false) {}

  void learn(const LabelledDecision& decision) {
    score(decision);
    find_errors(decision);
    errors_.assign(decision.bundles.size(), 0.0F);
    for (std::size_t i = 0; i < decision.candidates.size(); ++i)
      for (const std::uint32_t bundle : decision.candidates[i]) errors_[bundle] += error_[i];
    for (std::size_t b = 0; b < errors_.size(); ++b)
      if (std::abs(errors_[b]) >= least_error_) add_gradient(decision.bundles[b], errors_[b]);
    for (const WeightRow row : touched_) {
      optimizer_.update(row, &gradient_[row.index]);
      gradient_[row.index] = 0;
      met_[row.index] = false;
    }
    touched_.clear();
  }

 private:
  static constexpr float margin = 1;  // by which the rival is to score less

  void score(const LabelledDecision& decision) {
    bundles_.assign(decision.bundles.size(), 0.0F);
    for (std::size_t b = 0; b < bundles_.size(); ++b)
      for (const auto [row, value] : decision.bundles[b]) bundles_[b] += *weights_.row(row) * value;
    scores_.assign(decision.candidates.size(), 0.0F);
    for (std::size_t i = 0; i < scores_.size(); ++i)
      for (const std::uint32_t bundle : decision.candidates[i]) scores_[i] += bundles_[bundle];
  }

  // The derivative of the objective by the score of each candidate: what is wanted of it less its probability.
  void find_errors(const LabelledDecision& decision) {
    error_.assign(scores_.size(), 0.0F);
    const float behind = decision.rival ? scores_[*decision.rival] - scores_[decision.right.front()] : 0;
    const float push = decision.rival ? against_rival_ / (1 + std::exp(-behind - margin)) : 0;
    const float highest = *std::max_element(scores_.begin(), scores_.end());
    float total = 0, right = 0;
    for (float& score : scores_) total += score = std::exp(score - highest);
    for (const std::size_t i : decision.right) right += scores_[i];
    for (const std::size_t i : decision.right)
      error_[i] = right > 0 ? scores_[i] / right : 1.0F / static_cast<float>(decision.right.size());
    error_[decision.right.front()] += push;
    for (std::size_t i = 0; i < error_.size(); ++i) error_[i] -= scores_[i] / total;
    if (decision.rival) error_[*decision.rival] -= push;
  }

  void add_gradient(const std::vector<LabelledDecision::Row>& bundle, float error) {
    for (const auto [row, value] : bundle) {
      if (!met_[row.index] || (decay_again_ && gradient_[row.index] == 0)) touched_.push_back(row);
      met_[row.index] = true;
      gradient_[row.index] += error * value;
    }
  }

  WeightTable& weights_;
  AdaGrad optimizer_;
  float least_error_, against_rival_;
  bool decay_again_;
  std::vector<float> gradient_, bundles_, scores_, error_, errors_;
  std::vector<bool> met_;  // rows of the decision
  std::vector<WeightRow> touched_;
};

void leave_out_rare_features(std::size_t rows, std::span<LabelledDecision> decisions, std::size_t least_maps) {
  std::vector<std::uint64_t> maps(rows, 0);  // of each row, as bits
  std::uint64_t all = 0;
  for (const LabelledDecision& decision : decisions) {
    const std::uint64_t map = std::uint64_t{1} << (decision.map % 64);
    all |= map;
    for (const auto& bundle : decision.bundles)
      for (const auto& feature : bundle) maps[feature.row.index] |= map;
  }
  const int least = std::min(static_cast<int>(least_maps), std::popcount(all));
  for (LabelledDecision& decision : decisions)
    for (auto& bundle : decision.bundles)
      std::erase_if(bundle, [&](const auto& feature) { return std::popcount(maps[feature.row.index]) < least; });
}

}  // namespace

LabelledDecision numbered(const CandidateFeatures& features, WeightTable& weights) {
  LabelledDecision decision;
  for (const auto& bundle : features.bundles) {
    auto& rows = decision.bundles.emplace_back();
    rows.reserve(bundle.size());
    for (const WeightedFeature& feature : bundle) rows.push_back({weights.add(feature.key), feature.value});
  }
  decision.candidates = features.candidates;
  return decision;
}

void learn_ranker(WeightTable& weights, std::span<LabelledDecision> decisions, const RankerOptions& options,
                  const JobProgress& progress) {
  if (options.least_maps > 1) leave_out_rare_features(weights.rows(), decisions, options.least_maps);
  RankerLearner learner(weights, options);
  ltl::Random random(options.seed);
  const auto below = [&](std::size_t n) { return random.below(n); };
  each_epoch(decisions.size(), options.epochs, below, [&](std::span<const std::size_t> order, int epoch) {
    for (const std::size_t i : order) {
      if (options.stop.stop_requested()) throw Stopped{};
      learner.learn(decisions[i]);
    }
    progress(static_cast<double>(epoch + 1) / options.epochs);
  });
}

}  // namespace waymark::parser
