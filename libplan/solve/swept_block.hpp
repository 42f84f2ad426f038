// A block of a product swept state by state, its equations not written out: optimistic value iteration [HK20, Alg. 2].
//
// For blocks that are too large to be written out and no grids. Sixteen bytes a state of the product, since outcomes are
// told by state.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/solve/bellman_operator.hpp"
#include "libplan/solve/equations.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

template <class Product, Measure measure>
class SweptBlock {  // all of them must outlive it
 public:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  SweptBlock(const Product& product, const EndComponentQuotient<Product>& merged,
             const BellmanOperator<Product, measure>& best)
      : product_(product), merged_(merged), best_(best), lower_(product.states(), 0), upper_(lower_) {}

  void know(std::uint32_t state, double lower, double upper) {  // of states outside
    lower_[state] = lower;
    upper_[state] = upper;
  }
  double lower(std::uint32_t state) const { return lower_[state]; }
  double upper(std::uint32_t state) const { return upper_[state]; }

  // How many sweeps it took; nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<std::uint64_t> solve(const std::vector<Compact>& order, const IterationLimits& limits) {
    std::uint64_t swept = 0, all = 0;
    for (double fine = limits.tolerance / 16;; fine = fine < 1e-18 ? 0 : fine / 64) {
      std::uint64_t sweeps = 1;
      while (raise(order) > fine) {
        ++sweeps;
        if (sweeps + swept > limits.sweeps || limits.stop.stop_requested()) return std::nullopt;
      }
      guess_upper(order, limits.tolerance);
      bool proved = false;
      for (std::uint64_t tries = 0; tries < sweeps + 8 && !proved; ++tries, ++all) {
        proved = lower_upper(order);
        if (limits.stop.stop_requested()) return std::nullopt;
      }
      all += sweeps;
      swept += sweeps;
      if (proved) return all;
      if (fine == 0) return std::nullopt;
    }
  }

 private:
  // The greatest change: absolute for probabilities, relative for costs.
  double raise(const std::vector<Compact>& order) {
    double change = 0;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      const double old = lower_[s.index], value = std::max(old, best_.of_all(s, lower_));
      if (value == old) continue;
      change = std::max(change, is_probability(measure) ? value - old : (value - old) / value);
      merged_.set(s, lower_, value);
    }
    return change;
  }

  void guess_upper(const std::vector<Compact>& order, double tolerance) {
    const double gap = tolerance / 2;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      const double lower = lower_[s.index];
      merged_.set(s, upper_, is_probability(measure) ? std::min(1.0, lower + gap) : lower * (1 + gap));
    }
  }

  // One sweep of the upper values; true: it would have raised none.
  bool lower_upper(const std::vector<Compact>& order) {
    bool inductive = true;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      const double old = upper_[s.index], value = best_.of_all(s, upper_);
      inductive = inductive && (!raises(old, value) || (is_probability(measure) && old == 1));
      if (value < old) merged_.set(s, upper_, value);
    }
    return inductive;
  }

  const Product& product_;
  const EndComponentQuotient<Product>& merged_;
  const BellmanOperator<Product, measure>& best_;
  std::vector<double> lower_, upper_;
};

}  // namespace waymark::plan
