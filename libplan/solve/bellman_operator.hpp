// Φ at one state: its best action value, given values of all states (the operator of value_iteration.hpp).
//
// A choice that may come to nothing is taken until it comes to something: its value is divided by the chance that it
// does.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "libplan/solve/equations.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

template <class Product, Measure measure>
class BellmanOperator {  // all of them must outlive it
 public:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  BellmanOperator(const Product& product, const Unknowns& unknowns, const EndComponentQuotient<Product>& merged)
      : product_(product), unknowns_(unknowns), merged_(merged) {}

  // One state.
  double of(const State& s, const std::vector<double>& values) const {
    const std::uint32_t own = merged_.component(s.index);
    double best = worst();
    const std::uint32_t choices = product_.choices(s);
    for (std::uint32_t k = 0; k < choices; ++k) {
      double sum = measure == Measure::MinCost ? product_.cost(s, k) : 0, stays = 0;
      bool counts = true;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t == s.index || (t != Product::trap && own != EndComponents::none && merged_.component(t) == own)) {
          stays += p;
        } else if (t != Product::trap && (is_probability(measure) || unknowns_.unknown[t] || unknowns_.targets[t])) {
          sum += p * values[t];
        } else {
          counts = counts && is_probability(measure);
        }
      });
      if (!counts) continue;
      if (!(stays < 1 - 1e-12)) continue;  // never leaves
      sum /= 1 - stays;
      if (better(sum, best)) best = sum;
    }
    return best;
  }

  // All states that have one value with it.
  double of_all(const State& s, const std::vector<double>& values) const {
    const std::uint32_t own = merged_.component(s.index);
    if (own == EndComponents::none) return of(s, values);
    double best = worst();
    for (const Compact& member : merged_.members(own)) {
      const double value = of(product_.state(member), values);
      if (better(value, best)) best = value;
    }
    return best;
  }

 private:
  static bool better(double a, double b) { return measure == Measure::MaxProbability ? a > b : a < b; }
  static constexpr double worst() { return measure == Measure::MaxProbability ? 0 : INFINITY; }

  const Product& product_;
  const Unknowns& unknowns_;
  const EndComponentQuotient<Product>& merged_;
};

}  // namespace waymark::plan
