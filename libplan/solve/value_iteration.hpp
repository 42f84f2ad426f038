// Values of a Markov decision process between proved bounds: optimistic value iteration [HK20, Alg. 2].
//
// From below, values grow in place until they hardly change; then a little is added to all of them, and when one more
// sweep raises none, they are an upper bound: whatever Φ does not raise lies above its least fixpoint, the value. Else
// the iteration from below goes on with a finer measure. Interval iteration, which comes down from 1, does not close
// where a strategy can waste time almost for ever.
//
// Blocks of the product are solved in the order in which outcomes lead, each in the order of distance from what is
// solved, so that a sweep carries news all the way. States between which one can move at will and for nothing have one
// value and are swept as one (`merged`): otherwise they could hold each other up. A choice that may come to nothing is
// taken until it comes to something: its value is divided by the chance that it does.
// Bounds are sound up to the rounding of doubles, as in the tools we compare with.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <vector>

#include "libplan/solve/best_value.hpp"
#include "libplan/solve/equations.hpp"
#include "libplan/solve/grid_block.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

struct Values {
  std::vector<double> lower, upper;  // by state; of targets 1 (probability) or 0 (cost)
  std::uint64_t sweeps = 0;
};

template <class Product, Measure measure>
class ValueIteration {
 public:
  // claimed: bounds by state that may be tried first (GridBlock::start_from), and are written over; or none
  ValueIteration(const Product& product, const Unknowns& unknowns, const IterationLimits& limits,
                 std::optional<Values> claimed = std::nullopt)
      : product_(product),
        unknowns_(unknowns),
        limits_(limits),
        merged_(product, unknowns),
        best_(product, unknowns, merged_),
        has_claims_(claimed.has_value()),
        values_(claimed ? std::move(*claimed) : Values{}) {}

  std::optional<Values> run() {  // nullopt: stopped, out of sweeps, or the bounds do not meet in doubles
    begin();
    const std::vector<std::uint32_t>& blocks = product_.blocks();
    for (std::size_t b = 0; b + 1 < blocks.size(); ++b)
      if (!solve_block(blocks[b], blocks[b + 1])) return std::nullopt;
    return std::move(values_);
  }

 private:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  // Unknowns are 0, or what is claimed of them until their block is solved.
  void begin() {
    const double target_value = is_probability(measure) ? 1 : 0;
    values_.lower.resize(product_.states());
    values_.upper.resize(product_.states());
    values_.sweeps = 0;
    for (std::uint32_t i = 0; i < product_.states(); ++i)
      if (!unknowns_.unknown[i] || unknowns_.targets[i])
        values_.lower[i] = values_.upper[i] = unknowns_.targets[i] ? target_value : 0;
  }

  // The greatest change: absolute for probabilities, relative for costs.
  double raise(const std::vector<Compact>& order) {
    double change = 0;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      const double old = values_.lower[s.index], value = std::max(old, best_.of_all(s, values_.lower));
      if (value == old) continue;
      change = std::max(change, is_probability(measure) ? value - old : (value - old) / value);
      merged_.set(s, values_.lower, value);
    }
    return change;
  }

  void guess_upper(const std::vector<Compact>& order) {
    const double gap = limits_.tolerance / 2;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      const double lower = values_.lower[s.index];
      merged_.set(s, values_.upper, is_probability(measure) ? std::min(1.0, lower + gap) : lower * (1 + gap));
    }
  }

  // One sweep of the upper values; true: it would have raised none.
  bool lower_upper(const std::vector<Compact>& order) {
    bool inductive = true;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      const double old = values_.upper[s.index], value = best_.of_all(s, values_.upper);
      inductive = inductive && (!raises(old, value) || (is_probability(measure) && old == 1));
      if (value < old) merged_.set(s, values_.upper, value);
    }
    return inductive;
  }

  bool solve_block(std::uint32_t first, std::uint32_t last) {
    const std::vector<Compact> order = merged_.in_order(first, last);
    if (order.empty()) return true;
    if constexpr (std::is_same_v<Product, GridBlock::Product> ||
                  std::is_same_v<Product, StrategyChain<GridBlock::Product>>)
      if (order.size() > limits_.on_grid && !limits_.linear_solves)
        if (auto block = grid_block(order)) {
          if (solve_on_grid(order, *block)) return true;
          if (order.size() > Equations::factored || limits_.stop.stop_requested()) return false;
        }
    return order.size() <= limits_.written_out ? solve_equations(order, first, last) : sweep(order);
  }

  std::optional<GridBlock> grid_block(const std::vector<Compact>& order) const {
    if constexpr (std::is_same_v<Product, GridBlock::Product>)
      return GridBlock::of(product_, unknowns_, measure, order, values_.lower, values_.upper);
    else
      return GridBlock::of(product_.product(), unknowns_, measure, order, values_.lower, values_.upper,
                           &product_.strategy());
  }

  bool solve_on_grid(const std::vector<Compact>& order, GridBlock& block) {
    if (has_claims_) block.start_from(values_.lower, values_.upper);
    const auto sweeps = block.solve(limits_);
    if (!sweeps) return false;
    for (const Compact& c : order) {
      const std::uint32_t i = product_.state(c).index;
      values_.lower[i] = block.lower(c.place);
      values_.upper[i] = block.upper(c.place);
    }
    values_.sweeps += *sweeps;
    return true;
  }

  // The rows of the block. Outcomes among merged states come to nothing.
  bool solve_equations(const std::vector<Compact>& order, std::uint32_t first, std::uint32_t last) {
    Equations equations(measure);
    first_ = first;
    row_.assign(last - first, no_row);
    for (std::uint32_t i = 0; i < order.size(); ++i) number(product_.state(order[i]), i);
    for (const Compact& c : order) {
      equations.add_row();
      const State s = product_.state(c);
      if (const std::uint32_t own = merged_.component(s.index); own == EndComponents::none)
        add_choices(s, equations);
      else
        for (const Compact& member : merged_.members(own)) add_choices(product_.state(member), equations);
    }
    const auto solution = equations.solve(limits_);
    if (!solution) return false;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      const State s = product_.state(order[i]);
      merged_.set(s, values_.lower, solution->lower[i]);
      merged_.set(s, values_.upper, solution->upper[i]);
    }
    values_.sweeps += solution->sweeps;
    return true;
  }

  void number(const State& s, std::uint32_t row) {
    if (const std::uint32_t own = merged_.component(s.index); own == EndComponents::none)
      row_[s.index - first_] = row;
    else
      for (const Compact& member : merged_.members(own)) row_[product_.state(member).index - first_] = row;
  }

  std::uint32_t row(std::uint32_t i) const {  // of states outside the block there is none
    return i - first_ < row_.size() ? row_[i - first_] : no_row;
  }
  void add_choices(const State& s, Equations& equations) const {
    const std::uint32_t own = row(s.index), choices = product_.choices(s);
    for (std::uint32_t k = 0; k < choices; ++k) {
      const double cost = measure == Measure::MinCost ? product_.cost(s, k) : 0;
      double below = cost, above = cost, stays = 0, least_known = INFINITY;
      bool counts = true;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::lost && row(t) == own) {
          stays += p;
        } else if (t != Product::lost && row(t) == no_row &&
                   (is_probability(measure) || unknowns_.unknown[t] || unknowns_.targets[t])) {
          below += p * values_.lower[t];
          above += p * values_.upper[t];
          least_known = std::min(least_known, values_.lower[t]);
        } else if (t == Product::lost || row(t) == no_row) {
          counts = counts && is_probability(measure);
        }
      });
      if (!counts) continue;
      const bool leaves = stays < 1 - 1e-12;
      if (!leaves && measure != Measure::MinProbability) continue;
      equations.add_choice();
      const double scale = leaves ? 1 / (1 - stays) : 0;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::lost && row(t) != no_row && row(t) != own) equations.add_term(row(t), p * scale);
      });
      equations.end_choice({below * scale, above * scale, cost * scale, least_known});
    }
  }

  bool sweep(const std::vector<Compact>& order) {
    if (has_claims_)
      for (const Compact& c : order) merged_.set(product_.state(c), values_.lower, 0);
    std::uint64_t swept = 0;
    for (double fine = limits_.tolerance / 16;; fine = fine < 1e-18 ? 0 : fine / 64) {
      std::uint64_t sweeps = 1;
      while (raise(order) > fine) {
        ++sweeps;
        if (sweeps + swept > limits_.sweeps || limits_.stop.stop_requested()) return false;
      }
      guess_upper(order);
      bool proved = false;
      for (std::uint64_t tries = 0; tries < sweeps + 8 && !proved; ++tries, ++values_.sweeps) {
        proved = lower_upper(order);
        if (limits_.stop.stop_requested()) return false;
      }
      values_.sweeps += sweeps;
      swept += sweeps;
      if (proved) return true;
      if (fine == 0) return false;
    }
  }

  const Product& product_;
  const Unknowns& unknowns_;
  const IterationLimits& limits_;
  const MergedUnknowns<Product> merged_;
  const BestValue<Product, measure> best_;
  const bool has_claims_;
  Values values_;
  static constexpr std::uint32_t no_row = UINT32_MAX;
  std::uint32_t first_ = 0;         // of the block at hand
  std::vector<std::uint32_t> row_;  // of the block at hand, by state
};

}  // namespace waymark::plan
