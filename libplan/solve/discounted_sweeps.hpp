// Sweeps of the discounted optimality equation, from below and in place, over any product: of solvers, and of learners.
//
//   V(s) = max over choices of Σ Pr(t | s) · (1 if t is a goal, γ V(t) otherwise)           [SB18, Sec. 4.4]
// With γ < 1 a contraction: after a sweep that changed nothing by more than δ, values are within δ γ / (1 − γ) of V.
// With γ = 1 V is the greatest probability of reaching a goal, and the sweeps promise nothing but to come closer.
//
// Product: states, goals, choices and outcomes by the names that ProductMdp has for them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "libplan/solve/markov_chain.hpp"

namespace waymark::plan {

// The greatest change in a sweep after which values are no further off than `error`, or than rounding lets them be.
inline double discounted_change(double error, double discount) {
  return std::max(error, 1e-15) * (1 - discount) / discount;
}

template <class Product>
class DiscountedSweeps {
 public:
  DiscountedSweeps(const Product& product, double discount)
      : product_(product), discount_(discount), values_(product.states(), 0) {
    product.for_each_state([&](const auto& s) {
      if (product.is_goal(s)) values_[s.index] = 1 / discount;  // so that γ V is 1
    });
  }

  // Until a sweep changes nothing by more than `enough` of what it becomes: γ^n is small, and a goal a thousand steps
  // away is one all the same. False: stopped, or so many sweeps were made.
  bool run(double enough, const std::stop_token& stop, std::uint64_t most = UINT64_MAX) {
    for (double change = 2 * enough + 1; change > enough; ++sweeps_) {
      if (stop.stop_requested() || sweeps_ == most) return false;
      change = 0;
      product_.for_each_state([&](const auto& s) {
        if (product_.is_goal(s)) return;
        const double value = best(s).value;
        if (!(value > values_[s.index])) return;
        change = std::max(change, (value - values_[s.index]) / value);
        values_[s.index] = value;
      });
    }
    return true;
  }

  struct Best {                             // of a state
    std::uint32_t choice = Strategy::none;  // none of a goal
    double value = 0;                       // of that choice
  };
  // The first best choice, up to a relative `slack`; none where nothing is to be gained.
  template <class State>
  Best best(const State& s, double slack = 0) const {
    Best out;
    for (std::uint32_t k = 0; k < product_.choices(s); ++k) {
      double sum = 0;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::trap) sum += p * discount_ * values_[t];
      });
      if (sum > out.value * (1 + slack)) out = {k, sum};
    }
    return out;
  }
  double value(std::uint32_t i) const { return std::min(values_[i], 1.0); }
  std::uint64_t sweeps() const { return sweeps_; }

 private:
  const Product& product_;
  double discount_;
  std::vector<double> values_;
  std::uint64_t sweeps_ = 0;
};

}  // namespace waymark::plan
