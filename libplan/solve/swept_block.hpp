// A block of a product swept state by state, its equations not written out: optimistic value iteration [HK20, Alg. 2].
//
// For blocks that are too large to be written out and no grids. Sixteen bytes a state of the product, since outcomes
// are told by state.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/solve/bellman_operator.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
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
  double lower(std::uint32_t state) const { return lower_[state]; }  // bound
  double upper(std::uint32_t state) const { return upper_[state]; }  // bound

  // How many sweeps it took; nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<std::uint64_t> solve(const std::vector<Compact>& order, const IterationOptions& options) {
    order_ = &order;
    if (iterate_optimistically(*this, options, options.tolerance / 16) != IterationEnd::Proved) return std::nullopt;
    return sweeps();
  }

  // The backend of optimistic_iteration.hpp.
  std::uint64_t sweeps() const { return refining_ + proving_; }
  bool refine(double change, const IterationOptions& options) {
    for (++refining_; raise() > change;)
      if (++refining_ > options.sweeps || options.stop.stop_requested()) return false;
    return true;
  }
  void guess(double tolerance) {
    const double gap = tolerance / 2;
    for (const Compact& c : *order_) {
      const State s = product_.state(c);
      const double lower = lower_[s.index];
      merged_.set(s, upper_, is_probability(measure) ? std::min(1.0, lower + gap) : lower * (1 + gap));
    }
  }
  bool prove(std::uint64_t sweeps, const IterationOptions& options) {
    bool proved = false;
    for (std::uint64_t tries = 0; tries < sweeps + 8 && !proved && !options.stop.stop_requested(); ++tries) {
      proved = lower_upper();
      ++proving_;
    }
    return proved;
  }

 private:
  // The greatest change: absolute for probabilities, relative for costs.
  double raise() {
    double change = 0;
    for (const Compact& c : *order_) {
      const State s = product_.state(c);
      const double old = lower_[s.index], value = std::max(old, best_.of_all(s, lower_));
      if (value == old) continue;
      change = std::max(change, is_probability(measure) ? value - old : (value - old) / value);
      merged_.set(s, lower_, value);
    }
    return change;
  }

  // One sweep of the upper values; true: it would have raised none.
  bool lower_upper() {
    bool inductive = true;
    for (const Compact& c : *order_) {
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
  const std::vector<Compact>* order_ = nullptr;  // of the block, as it is swept
  std::vector<double> lower_, upper_;
  std::uint64_t refining_ = 0, proving_ = 0;  // sweeps
};

}  // namespace waymark::plan
