#include "libplan/solve/equations.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace waymark::plan {

double Equations::value(std::uint32_t choice, const std::vector<double>& x, Side side) const {
  double sum = constant_[side][choice];
  for (std::uint32_t t = first_term_[choice]; t < first_term_[choice + 1]; ++t)
    sum += coefficient_[t] * x[unknown_[t]];
  return sum;
}

double Equations::best(std::uint32_t row, const std::vector<double>& x, Side side) const {
  double best = measure_ == Measure::MaxProbability ? 0 : INFINITY;
  for (std::uint32_t c = first_choice_[row]; c < first_choice_[row + 1]; ++c) {
    const double offered = value(c, x, side);
    if (better(offered, best)) best = offered;
  }
  return best;
}

// One sweep from below; the greatest change, absolute for probabilities, relative for costs.
double Equations::raise() {
  double change = 0;
  for (std::uint32_t i = 0; i < rows(); ++i) {
    const double old = x_.lower[i], now = std::max(old, best(i, x_.lower, Below));
    if (now == old) continue;
    change = std::max(change, is_probability(measure_) ? now - old : (now - old) / now);
    x_.lower[i] = now;
  }
  return change;
}

// One sweep from above; true: it would have raised nothing, so these are upper bounds.
bool Equations::close_from_above() {
  bool inductive = true;
  for (std::uint32_t i = 0; i < rows(); ++i) {
    const double now = best(i, x_.upper, Above);
    inductive = inductive && (!raises(x_.upper[i], now) || (is_probability(measure_) && x_.upper[i] == 1));
    x_.upper[i] = std::min(x_.upper[i], now);
  }
  return inductive;
}

void Equations::guess_above(double tolerance) {
  for (std::uint32_t i = 0; i < rows(); ++i)
    x_.upper[i] = is_probability(measure_) ? std::min(1.0, x_.lower[i] + tolerance / 2)
                                           : x_.lower[i] * (1 + tolerance / 2);
}

bool Equations::prove(double tolerance, std::uint64_t sweeps) {
  guess_above(tolerance);
  for (std::uint64_t tries = 0; tries < sweeps; ++tries, ++x_.sweeps)
    if (close_from_above()) return true;
  return false;
}

std::optional<Equations::Solution> Equations::solve(const IterationLimits& limits) {
  first_choice_.push_back(choices());
  first_term_.push_back(static_cast<std::uint32_t>(unknown_.size()));
  x_.lower.assign(rows(), 0);
  x_.upper.assign(rows(), 0);
  constexpr std::uint64_t patience = 100;  // sweeps; then factors are cheaper
  bool factors = limits.linear_solves;
  for (double fine = limits.tolerance / 16;; fine = fine < 1e-18 ? 0 : fine / 64) {
    const std::uint64_t before = x_.sweeps;
    if (factors && measure_ != Measure::MinProbability) {
      if (!iterate_policies(limits)) return std::nullopt;
    } else {
      while (++x_.sweeps, raise() > fine) {
        if (x_.sweeps > limits.sweeps || limits.stop.stop_requested()) return std::nullopt;
        factors = measure_ == Measure::MaxProbability && x_.sweeps > patience;
        if (factors) break;
      }
      if (factors) continue;
    }
    if (prove(limits.tolerance, x_.sweeps - before + 64)) return std::move(x_);
    if (fine == 0) return std::nullopt;
  }
}

// Rows that have something to gain at once, then rows with a choice that may lead to one of those, and so on.
std::vector<std::uint32_t> Equations::progress() const {
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> policy(rows(), none);
  std::vector<std::vector<std::uint32_t>> sources(rows());  // (row, choice) as choice
  std::vector<std::uint32_t> row_of(choices()), open;
  for (std::uint32_t i = 0; i < rows(); ++i)
    for (std::uint32_t c = first_choice_[i]; c < first_choice_[i + 1]; ++c) {
      row_of[c] = i;
      double leads_on = 0;
      for (std::uint32_t t = first_term_[c]; t < first_term_[c + 1]; ++t) {
        sources[unknown_[t]].push_back(c);
        leads_on += coefficient_[t];
      }
      if (policy[i] == none && leads_on < 1 - 1e-12) {
        policy[i] = c;
        open.push_back(i);
      }
    }
  for (std::size_t n = 0; n < open.size(); ++n)
    for (std::uint32_t c : sources[open[n]])
      if (policy[row_of[c]] == none) {
        policy[row_of[c]] = c;
        open.push_back(row_of[c]);
      }
  return policy;
}

std::vector<std::uint32_t> Equations::greedy() const {
  std::vector<std::uint32_t> policy;
  for (std::uint32_t i = 0; i < rows(); ++i) {
    std::uint32_t chosen = first_choice_[i];
    for (std::uint32_t c = chosen + 1; c < first_choice_[i + 1]; ++c)
      if (better(value(c, x_.lower, Below), value(chosen, x_.lower, Below))) chosen = c;
    policy.push_back(chosen);
  }
  return policy;
}

// (I − P) x = constant, by sparse LU. False: singular, the policy goes round for ever.
bool Equations::evaluate(const std::vector<std::uint32_t>& policy, std::vector<double>& x) const {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(rows());
  for (std::uint32_t i = 0; i < rows(); ++i) {
    const auto row = static_cast<int>(i);
    entries.emplace_back(row, row, 1.0);
    for (std::uint32_t t = first_term_[policy[i]]; t < first_term_[policy[i] + 1]; ++t)
      entries.emplace_back(row, static_cast<int>(unknown_[t]), -coefficient_[t]);
    right[row] = constant_[Below][policy[i]];
  }
  Eigen::SparseMatrix<double> matrix(static_cast<int>(rows()), static_cast<int>(rows()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
  factors.compute(matrix);
  if (factors.info() != Eigen::Success) return false;
  Eigen::VectorXd solved = factors.solve(right);
  solved += factors.solve(
      right - matrix * solved);  // one step of refinement: the residual is what bounds are proved by
  x.assign(solved.data(), solved.data() + solved.size());
  for (double& v : x) {
    if (!(v >= -1e-9) || std::isinf(v)) return false;
    v = is_probability(measure_) ? std::clamp(v, 0.0, 1.0) : std::max(v, 0.0);  // rounding
  }
  return true;
}

// Lower bounds are the values of a policy that no single change of a choice betters.
bool Equations::iterate_policies(const IterationLimits& limits) {
  const bool warm = measure_ == Measure::MaxProbability && x_.sweeps > 0;
  std::vector<std::uint32_t> policy = warm ? greedy() : progress();
  std::vector<double> x;
  for (bool changed = true; changed; ++x_.sweeps) {
    if (limits.stop.stop_requested() || !evaluate(policy, x)) return false;
    changed = false;
    for (std::uint32_t i = 0; i < rows(); ++i) {
      const double gain = 1e-12 * std::max(x[i], 1e-300);
      double held = value(policy[i], x, Below);
      for (std::uint32_t c = first_choice_[i]; c < first_choice_[i + 1]; ++c) {
        const double offered = value(c, x, Below);
        if (measure_ == Measure::MaxProbability ? offered <= held + gain : offered >= held - gain) continue;
        policy[i] = c;
        held = offered;
        changed = true;
      }
    }
  }
  x_.lower = std::move(x);
  return true;
}

}  // namespace waymark::plan
