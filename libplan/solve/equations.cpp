#include "libplan/solve/equations.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <queue>
#include <utility>

namespace waymark::plan {
namespace {

constexpr double rounding = 1e-15;   // of the sum of a row
constexpr double most_error = 1e-9;  // of a probability
constexpr double most_steps = 1e12;  // of a policy whose costs are bounds: rounding adds up

}  // namespace

double Equations::value(std::uint32_t choice, const std::vector<double>& x, Side side) const {
  double sum = constant_[side][choice];
  for (std::uint32_t t = first_term_[choice]; t < first_term_[choice + 1]; ++t) sum += coefficient_[t] * x[unknown_[t]];
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

// The chunks that are swept, and which go together: a row of one has a term of the other. One chunk for one thread.
void Equations::make_chunks(std::size_t threads) {
  constexpr std::uint32_t worth_sharing = 4'096, rows_of_a_chunk = 256;
  const bool alone = threads <= 1 || rows() < worth_sharing;
  chunk_size_ = alone ? std::max(rows(), 1U) : rows_of_a_chunk;
  reach_ = ChunkReach((rows() + chunk_size_ - 1) / chunk_size_);
  if (alone) return;
  for (std::uint32_t i = 0; i < rows(); ++i)
    for (std::uint32_t t = first_term_[first_choice_[i]]; t < first_term_[first_choice_[i + 1]]; ++t)
      reach_.relate(i / chunk_size_, unknown_[t] / chunk_size_);
}

// The chunk from below; the greatest change, absolute for probabilities, relative for costs.
double Equations::raise(std::size_t chunk) {
  double change = 0;
  const std::uint32_t end = chunk_end(chunk);
  for (auto i = static_cast<std::uint32_t>(chunk) * chunk_size_; i < end; ++i) {
    const double old = x_.lower[i], now = std::max(old, best(i, x_.lower, Below));
    if (now == old) continue;
    change = std::max(change, is_probability(measure_) ? now - old : (now - old) / now);
    x_.lower[i] = now;
  }
  return change;
}

// The chunk from above; true: it would have raised nothing by more than its rounding, so these are upper bounds.
bool Equations::close_from_above(std::size_t chunk) {
  bool inductive = true;
  const std::uint32_t end = chunk_end(chunk);
  for (auto i = static_cast<std::uint32_t>(chunk) * chunk_size_; i < end; ++i) {
    const double now = best(i, x_.upper, Above);
    inductive = inductive && (!raises(x_.upper[i], now) || (is_probability(measure_) && x_.upper[i] == 1));
    x_.upper[i] = std::min(x_.upper[i], now);
  }
  return inductive;
}

// Sweeps until one finds all bounds inductive: at most so many. That one is not counted.
bool Equations::close_in_sweeps(std::uint64_t most, std::size_t threads) {
  bool inductive = false;
  const auto work = [&](std::size_t chunk, const Pass&) { return close_from_above(chunk); };
  const auto after = [&, tries = std::uint64_t{0}](const Pass& pass, std::size_t unsettled) mutable {
    inductive = unsettled == pass.end;
    if (inductive) return std::optional<Pass>();
    ++x_.sweeps;
    return ++tries == most ? std::nullopt : std::optional(pass);
  };
  pipelined_passes(reach_, threads, {0, reach_.chunks()}, work, after);
  return inductive;
}

void Equations::guess(double tolerance) {
  for (std::uint32_t i = 0; i < rows(); ++i)
    x_.upper[i] =
        is_probability(measure_) ? std::min(1.0, x_.lower[i] + tolerance / 2) : x_.lower[i] * (1 + tolerance / 2);
}

bool Equations::prove(std::uint64_t sweeps, const IterationOptions& options) {
  const std::uint64_t most = by_policies_ ? most_tries : sweeps + most_tries;
  if (close_in_sweeps(most, options.sweepers.free())) return true;
  return by_policies_ && measure_ == Measure::MaxProbability && raise_to_bounds(options);
}

// Where runs linger, a row's bound differs from those of the rows around it by rounding and by what a policy may leave
// to gain. So the values of the policy, more by what those of solved states may be more, are raised until a sweep
// raises none: soon, where that was all. A strategy that gains little in a step and takes many raises them again and
// again, which proves nothing. What a sweep may round in each step of the policy is added.
bool Equations::raise_to_bounds(const IterationOptions& limits) {
  constexpr int most_sweeps = 2'000;
  constexpr double of_a_row = 4 * rounding;  // whose coefficients are rounded, too
  std::vector<double> x = x_.lower;
  const double wider = width_of_known();
  for (double& bound : x) bound = std::min(1.0, bound + wider);
  bool raised = true;
  for (int sweep = 0; raised; ++sweep, ++x_.sweeps) {
    if (sweep == most_sweeps || limits.stop.stop_requested()) return false;
    raised = false;
    for (std::uint32_t i = 0; i < rows(); ++i) {
      const double now = std::min(1.0, best(i, x, Above));
      if (now <= x[i] * (1 + of_a_row)) continue;
      x[i] = now;
      raised = true;
    }
  }
  for (std::uint32_t i = 0; i < rows(); ++i) {
    x[i] = std::min(1.0, x[i] + of_a_row * steps_);
    if (!(x[i] - x_.lower[i] <= limits.tolerance)) return false;
  }
  x_.upper = std::move(x);
  return true;
}

// The greatest difference of bounds of what is known, a share of all outcomes of the choice, among choices with some.
double Equations::width_of_known() const {
  double out = 0;
  for (std::uint32_t c = 0; c < choices(); ++c) {
    double known = 1;
    for (std::uint32_t t = first_term_[c]; t < first_term_[c + 1]; ++t) known -= coefficient_[t];
    if (known > most_error) out = std::max(out, (constant_[Above][c] - constant_[Below][c]) / known);
  }
  return out;
}

// Sweeps for a while; where that does not do, policies by linear solves; where these fail, sweeps again, for eight
// times as long, since values that are nearer make better policies to begin with.
bool Equations::refine(double change, const IterationOptions& options) {
  by_policies_ = false;
  const auto out_of_limits = [&] { return x_.sweeps > options.sweeps || options.stop.stop_requested(); };
  bool settled = false;
  while (!settled) {
    if (linear_ && x_.sweeps >= patience_) {
      patience_ = std::max<std::uint64_t>(100, 8 * patience_);
      by_policies_ = iterate_policies(options);
      linear_ = !by_policies_;
      if (by_policies_) return true;
      change /= 64;
    }
    if (out_of_limits()) return false;
    ++x_.sweeps;
    const auto work = [&](std::size_t chunk, const Pass&) { return raise(chunk) <= change; };
    const auto after = [&](const Pass& pass, std::size_t unsettled) -> std::optional<Pass> {
      settled = unsettled == pass.end;
      if (settled || (linear_ && x_.sweeps >= patience_) || out_of_limits()) return std::nullopt;
      ++x_.sweeps;
      return pass;
    };
    pipelined_passes(reach_, options.sweepers.free(), {0, reach_.chunks()}, work, after);
  }
  return true;
}

std::optional<Equations::Solution> Equations::solve(const IterationOptions& options) {
  first_choice_.push_back(choices());
  first_term_.push_back(static_cast<std::uint32_t>(unknown_.size()));
  x_.lower.assign(rows(), 0);
  x_.upper.assign(rows(), 0);
  if (measure_ == Measure::MinCost) start_from_best_luck();
  make_chunks(options.sweepers.threads);
  linear_ = rows() <= factored;
  patience_ = options.policy_iteration ? 0 : 100;
  if (iterate_optimistically(*this, options, options.tolerance / 16) != IterationEnd::Proved) return std::nullopt;
  return std::move(x_);
}

Equations::Sources Equations::sources() const {
  Sources out{std::vector<std::uint32_t>(rows() + 1, 0), std::vector<std::uint32_t>(unknown_.size()),
              std::vector<std::uint32_t>(choices())};
  for (std::uint32_t i : unknown_) ++out.first[i + 1];
  for (std::uint32_t i = 0; i < rows(); ++i) out.first[i + 1] += out.first[i];
  std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
  for (std::uint32_t i = 0; i < rows(); ++i)
    for (std::uint32_t c = first_choice_[i]; c < first_choice_[i + 1]; ++c) {
      out.row_of[c] = i;
      for (std::uint32_t t = first_term_[c]; t < first_term_[c + 1]; ++t) out.choice[next[unknown_[t]]++] = c;
    }
  return out;
}

// Costs if every choice came to what one would wish: the least way to anything known. It is no more than the value,
// and its gradient points the way; from zero, values would rise by no more than a cost a sweep.
void Equations::start_from_best_luck() {
  const Sources into = sources();
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  x_.lower.assign(rows(), INFINITY);
  const auto offer = [&](std::uint32_t row, double cost) {
    if (!(cost < x_.lower[row])) return;
    x_.lower[row] = cost;
    heap.push({cost, row});
  };
  for (std::uint32_t c = 0; c < choices(); ++c)
    if (least_known_[c] < INFINITY) offer(into.row_of[c], cost_[c] + least_known_[c]);
  while (!heap.empty()) {
    const auto [cost, i] = heap.top();
    heap.pop();
    if (cost > x_.lower[i]) continue;
    for (std::uint32_t n = into.first[i]; n < into.first[i + 1]; ++n)
      offer(into.row_of[into.choice[n]], cost + cost_[into.choice[n]]);
  }
}

// Rows that have something to gain at once, then rows with a choice that may lead to one of those, and so on.
Equations::Policy Equations::progress() const {
  constexpr std::uint32_t none = UINT32_MAX;
  const Sources into = sources();
  Policy policy(rows(), none);
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < rows(); ++i)
    for (std::uint32_t c = first_choice_[i]; c < first_choice_[i + 1] && policy[i] == none; ++c) {
      double leads_on = 0;
      for (std::uint32_t t = first_term_[c]; t < first_term_[c + 1]; ++t) leads_on += coefficient_[t];
      if (leads_on >= 1 - 1e-12) continue;
      policy[i] = c;
      open.push_back(i);
    }
  for (std::size_t n = 0; n < open.size(); ++n)
    for (std::uint32_t m = into.first[open[n]]; m < into.first[open[n] + 1]; ++m) {
      const std::uint32_t c = into.choice[m];
      if (policy[into.row_of[c]] != none) continue;
      policy[into.row_of[c]] = c;
      open.push_back(into.row_of[c]);
    }
  return policy;
}

// Where a run may linger almost for ever, choices that only put off what must come are worth the same in doubles as
// those that go on. Among equals those are taken by which the run ends soonest: least expected steps, by sweeps.
Equations::Policy Equations::greedy() const {
  constexpr double slack = 1e-9, settled = 1e-3;
  constexpr int most_sweeps = 2'000;
  Policy policy(rows());
  std::vector<double> steps(rows(), 0);
  std::vector<bool> good(choices());
  for (std::uint32_t i = 0; i < rows(); ++i) {
    const double most = best(i, x_.lower, Below);
    for (std::uint32_t c = first_choice_[i]; c < first_choice_[i + 1]; ++c) {
      const double offered = value(c, x_.lower, Below);
      good[c] = measure_ == Measure::MaxProbability ? offered >= most * (1 - slack) : offered <= most * (1 + slack);
    }
  }
  double change = INFINITY;
  for (int sweep = 0; sweep < most_sweeps && change > settled; ++sweep) {
    change = 0;
    for (std::uint32_t i = 0; i < rows(); ++i) {
      double least = INFINITY;
      for (std::uint32_t c = first_choice_[i]; c < first_choice_[i + 1]; ++c) {
        if (!good[c]) continue;
        double sum = 1;
        for (std::uint32_t t = first_term_[c]; t < first_term_[c + 1]; ++t) sum += coefficient_[t] * steps[unknown_[t]];
        if (sum >= least) continue;
        least = sum;
        policy[i] = c;
      }
      change = std::max(change, std::abs(least - steps[i]) / least);
      steps[i] = least;
    }
  }
  return policy;
}

// (I − P) x = constant, by sparse LU. False: singular, the policy goes round for ever. (BiCGSTAB with incomplete
// factors, tried for more rows than can be factored, stagnates on large grids and takes longer than sweeps do.)
// Greatest probabilities are also refused where a run may take so many steps that rounding could add up: the error is
// at most the greatest residual times the expected steps, which are solved for with the same factors.
bool Equations::evaluate(const Policy& policy, std::vector<double>& x) {
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
  solved +=
      factors.solve(right - matrix * solved);  // one step of refinement: the residual is what bounds are proved by
  const Eigen::VectorXd steps = factors.solve(Eigen::VectorXd::Ones(rows()));
  steps_ = steps.minCoeff() >= 0.5 ? steps.maxCoeff() : INFINITY;
  if (measure_ == Measure::MaxProbability) {
    const double residual = (right - matrix * solved).cwiseAbs().maxCoeff() + rounding;
    if (!(residual * steps_ <= most_error)) return false;
  }
  x.assign(solved.data(), solved.data() + solved.size());
  for (double& v : x) {
    if (!(v >= -1e-9) || std::isinf(v)) return false;
    v = is_probability(measure_) ? std::clamp(v, 0.0, 1.0) : std::max(v, 0.0);  // rounding
  }
  return true;
}

// The values of a policy that no single change of a choice betters, as lower bounds. Greatest probabilities are no less
// than those of any policy. Least costs are: so what is taken is proved by a sweep that lowers nothing, and is a
// billionth less where rounding keeps the values themselves from being proved. A policy of more than 10¹² expected
// steps is refused: the linear system is all but singular in doubles, its solution may be any number, and a sweep in
// doubles does not tell. False: no such policy, or no proof.
bool Equations::iterate_policies(const IterationOptions& limits) {
  std::vector<double> x = x_.lower;
  Policy policy = x_.sweeps > 0 ? greedy() : progress();
  constexpr int most_rounds = 200;
  bool changed = true;
  for (int round = 0; changed && round < most_rounds; ++round, ++x_.sweeps) {
    if (limits.stop.stop_requested() || !evaluate(policy, x)) return false;
    changed = false;
    for (std::uint32_t i = 0; i < rows(); ++i) {
      // What is gained from rounding alone may lead round in circles.
      const double gain = (measure_ == Measure::MaxProbability ? 1e-13 : 1e-11) * std::max(x[i], 1e-300);
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
  if (!(steps_ <= most_steps)) return false;
  for (double less : {0.0, 1e-9}) {
    std::vector<double> candidate = x;
    for (double& v : candidate) v *= 1 - less;
    if (measure_ == Measure::MaxProbability || lowers_nothing(candidate)) {
      x_.lower = std::move(candidate);
      return true;
    }
  }
  return false;
}

bool Equations::lowers_nothing(const std::vector<double>& x) const {
  for (std::uint32_t i = 0; i < rows(); ++i)
    if (raises(best(i, x, Below), x[i])) return false;
  return true;
}

}  // namespace waymark::plan
