#include "libparser/lifted/learn_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "libltl/structure/random.hpp"
#include "libneural/adam.hpp"
#include "libparser/lifted/matching_features.hpp"

namespace waymark::parser {
namespace {

using neural::Index;
using neural::Matrix;
using neural::Vector;

// Adam for columns that seldom have a gradient: a column moves only in the steps in which it has one.
class LazyAdam {
 public:
  LazyAdam(Index rows, Index columns) : mean_(Matrix::Zero(rows, columns)), square_(Matrix::Zero(rows, columns)) {}
  void begin(double rate) {
    ++steps_;
    rate_ = static_cast<float>(rate * std::sqrt(1 - std::pow(0.999, steps_)) / (1 - std::pow(0.9, steps_)));
  }
  void step(Matrix& values, Index column, const Vector& gradient) {
    auto mean = mean_.col(column);
    auto square = square_.col(column);
    mean = 0.9F * mean + 0.1F * gradient;
    square = 0.999F * square + 0.001F * gradient.cwiseAbs2();
    values.col(column).array() -= rate_ * mean.array() / (square.array().sqrt() + 1e-8F);
  }

 private:
  Matrix mean_, square_;
  int steps_ = 0;
  float rate_ = 0;
};

struct Row {
  std::vector<Index> features;
  LiftedScope scope;
  Index formula = 0;
};

class Learner {
 public:
  Learner(std::span<const LiftedExample> examples, const MatcherTraining& options)
      : options_(options), random_(options.seed) {
    choose_formulas(examples);
    choose_features(examples);
    if (rows_.empty()) throw std::invalid_argument("there is nothing to learn a matcher from");
    const auto draw = [&](Matrix& m, Index rows, Index columns) {
      m.resize(rows, columns);
      for (Index i = 0; i < m.size(); ++i) m.data()[i] = static_cast<float>(0.35 * (random_.unit() - 0.5));
    };
    draw(texts_, options.width, static_cast<Index>(text_keys_.size()));
    draw(formulas_, options.width + 1, static_cast<Index>(formula_keys_.size()));
  }

  std::shared_ptr<const FormulaMatcher> run(const std::function<void(double)>& progress) {
    LazyAdam texts(texts_.rows(), texts_.cols()), formulas(formulas_.rows(), formulas_.cols());
    const std::size_t steps = std::max<std::size_t>(1, options_.draws / options_.batch);
    for (std::size_t i = 0; i < steps; ++i) {
      const double done = static_cast<double>(i) / static_cast<double>(steps);
      texts.begin(options_.rate * (1 - done));
      formulas.begin(options_.rate * (1 - done));
      step(texts, formulas);
      if (progress && i % 64 == 0) progress(done);
    }
    return std::make_shared<const FormulaMatcher>(FeatureTable(text_keys_, texts_),
                                                  FeatureTable(formula_keys_, formulas_), known_);
  }

 private:
  static std::vector<Index> known_of(const std::vector<std::uint64_t>& keys, std::span<const std::uint64_t> features) {
    std::vector<Index> out;
    for (const std::uint64_t f : features)
      if (const auto at = std::lower_bound(keys.begin(), keys.end(), f); at != keys.end() && *at == f)
        out.push_back(static_cast<Index>(at - keys.begin()));
    return out;
  }

  void choose_formulas(std::span<const LiftedExample> examples) {
    std::map<Lifted, double> weights;
    for (const LiftedExample& e : examples) weights[e.lifted] += e.weight;
    for (const auto& [lifted, weight] : weights)
      if (weight >= options_.least_weight) known_.push_back(lifted);
    for (const Lifted& lifted : known_) {
      const auto features = matching_features(lifted);
      formula_keys_.insert(formula_keys_.end(), features.begin(), features.end());
    }
    std::sort(formula_keys_.begin(), formula_keys_.end());
    formula_keys_.erase(std::unique(formula_keys_.begin(), formula_keys_.end()), formula_keys_.end());
    for (const Lifted& lifted : known_) {
      features_of_formula_.push_back(known_of(formula_keys_, matching_features(lifted)));
      needed_.push_back(needed_scope(lifted));
    }
  }

  void choose_features(std::span<const LiftedExample> examples) {
    std::unordered_map<std::uint64_t, std::uint32_t> texts;
    std::vector<std::size_t> taken;
    std::vector<std::vector<std::uint64_t>> features;
    for (std::size_t i = 0; i < examples.size(); ++i) {
      if (!std::binary_search(known_.begin(), known_.end(), examples[i].lifted)) continue;
      taken.push_back(i);
      features.push_back(matching_features(examples[i].text));
      for (const std::uint64_t f : features.back()) ++texts[f];
    }
    std::vector<std::pair<std::uint32_t, std::uint64_t>> by_count;
    for (const auto& [feature, count] : texts)
      if (count >= options_.least_texts) by_count.emplace_back(count, feature);
    std::sort(by_count.rbegin(), by_count.rend());
    by_count.resize(std::min(by_count.size(), options_.most_features));
    for (const auto& [count, feature] : by_count) text_keys_.push_back(feature);
    std::sort(text_keys_.begin(), text_keys_.end());
    double total = 0;
    for (std::size_t k = 0; k < taken.size(); ++k) {
      const LiftedExample& e = examples[taken[k]];
      const auto at = std::lower_bound(known_.begin(), known_.end(), e.lifted);
      rows_.push_back({known_of(text_keys_, features[k]), e.text.scope, static_cast<Index>(at - known_.begin())});
      total += e.weight;
      up_to_.push_back(total);
    }
  }

  const Row& draw() {
    const auto at = std::upper_bound(up_to_.begin(), up_to_.end(), random_.unit() * up_to_.back());
    return rows_[std::min(static_cast<std::size_t>(at - up_to_.begin()), rows_.size() - 1)];
  }

  void step(LazyAdam& texts, LazyAdam& formulas) {
    const auto batch = static_cast<Index>(options_.batch), width = options_.width;
    std::vector<const Row*> rows;
    std::vector<std::vector<Index>> used(options_.batch);
    Matrix h = Matrix::Zero(width + 1, batch), mask = Matrix::Zero(width, batch);
    const auto kept = static_cast<float>(1 / (1 - options_.dropout));
    for (Index b = 0; b < batch; ++b) {
      rows.push_back(&draw());
      std::vector<Index>& features = used[static_cast<std::size_t>(b)];
      for (const Index f : rows.back()->features)
        if (!random_.chance(options_.feature_dropout)) features.push_back(f);
      auto sum = h.col(b).head(width);
      for (const Index f : features) sum += texts_.col(f);
      sum /= std::sqrt(static_cast<float>(features.size()) + 1);
      for (Index r = 0; r < width; ++r)
        if (h(r, b) > 0 && !random_.chance(options_.dropout)) mask(r, b) = kept;
      sum.array() *= mask.col(b).array();
      h(width, b) = 1;
    }
    Matrix g(width + 1, static_cast<Index>(known_.size()));
    for (Index k = 0; k < g.cols(); ++k) {
      const auto& features = features_of_formula_[static_cast<std::size_t>(k)];
      g.col(k).setZero();
      for (const Index f : features) g.col(k) += formulas_.col(f);
      g.col(k) /= std::sqrt(static_cast<float>(features.size()));
    }
    Matrix d = g.transpose() * h;  // scores, then their gradient
    for (Index b = 0; b < batch; ++b) soften(d, b, *rows[static_cast<std::size_t>(b)]);
    Matrix dg = h * d.transpose();
    Matrix dh = g.topRows(width) * d;
    dh.array() *= mask.array();
    move(texts, texts_, used, dh, [](std::size_t n) { return std::sqrt(static_cast<float>(n) + 1); });
    move(formulas, formulas_, features_of_formula_, dg, [](std::size_t n) { return std::sqrt(static_cast<float>(n)); });
  }

  // Scores of a column → (p − smoothed truth) / batch.
  void soften(Matrix& d, Index b, const Row& row) const {
    float highest = -INFINITY, total = 0;
    Index allowed = 0;
    for (Index k = 0; k < d.rows(); ++k) {
      if (!is_within(needed_[static_cast<std::size_t>(k)], row.scope)) {
        d(k, b) = -INFINITY;
        continue;
      }
      ++allowed;
      highest = std::max(highest, d(k, b));
    }
    for (Index k = 0; k < d.rows(); ++k) total += d(k, b) = std::exp(d(k, b) - highest);
    const auto smooth = static_cast<float>(options_.smoothing), n = static_cast<float>(options_.batch);
    for (Index k = 0; k < d.rows(); ++k) {
      const bool possible = is_within(needed_[static_cast<std::size_t>(k)], row.scope);
      const float truth = (k == row.formula ? 1 - smooth : 0) + (possible ? smooth / static_cast<float>(allowed) : 0);
      d(k, b) = (d(k, b) / total - truth) / n;
    }
  }

  // Gradients of sums of columns → of the columns, then a step.
  template <class Norm>
  static void move(LazyAdam& adam, Matrix& values, const std::vector<std::vector<Index>>& used, const Matrix& dsums,
                   const Norm& norm) {
    std::vector<std::pair<Index, Index>> by_feature;  // feature, sum
    for (std::size_t s = 0; s < used.size(); ++s)
      for (const Index f : used[s]) by_feature.emplace_back(f, static_cast<Index>(s));
    std::sort(by_feature.begin(), by_feature.end());
    Vector gradient(values.rows());
    for (std::size_t i = 0; i < by_feature.size();) {
      const Index feature = by_feature[i].first;
      gradient.setZero();
      for (; i < by_feature.size() && by_feature[i].first == feature; ++i) {
        const Index s = by_feature[i].second;
        gradient += dsums.col(s) / norm(used[static_cast<std::size_t>(s)].size());
      }
      adam.step(values, feature, gradient);
    }
  }

  const MatcherTraining& options_;
  ltl::Random random_;
  std::vector<Lifted> known_;
  std::vector<LiftedScope> needed_;
  std::vector<std::vector<Index>> features_of_formula_;
  std::vector<std::uint64_t> text_keys_, formula_keys_;
  std::vector<Row> rows_;
  std::vector<double> up_to_;
  Matrix texts_, formulas_;
};

}  // namespace

std::shared_ptr<const FormulaMatcher> learn_matcher(std::span<const LiftedExample> examples,
                                                    const MatcherTraining& options,
                                                    const std::function<void(double)>& progress) {
  return Learner(upright(examples), options).run(progress);
}

}  // namespace waymark::parser
