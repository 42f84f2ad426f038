// Of choices that are worth the same, those by which a run ends soonest.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "libplan/solve/strategy.hpp"

namespace waymark::plan {

// Of the good choices of the unknown states, those by which a run ends soonest: least expected steps, by sweeps until
// these hardly change. Good choices may lead back and forth almost for ever where all that can go wrong lies far away;
// what is lost in a step for want of a digit is then lost in every step of them. `order`: nearest first. False: a
// run of good choices may not end.
template <class Product, class Good>
bool hurry(const Product& product, const std::vector<std::uint32_t>& order, const Good& good,
           const std::stop_token& stop, Strategy& strategy) {
  constexpr int most_sweeps = 4'000;  // about as many as a run has steps
  constexpr float settled = 2e-4F;
  constexpr std::uint32_t remembered = 8;  // choices of a state that are judged once
  std::vector<std::uint8_t> judged(product.states(), 0);
  for (const std::uint32_t i : order) {
    const auto s = product.state(i);
    for (std::uint32_t k = 0; k < std::min(product.choices(s), remembered); ++k)
      if (good(s, k)) judged[i] = static_cast<std::uint8_t>(judged[i] | 1U << k);
  }
  std::vector<float> steps(product.states(), 0);
  float change = INFINITY;
  for (int sweep = 0; sweep < most_sweeps && change > settled && !stop.stop_requested(); ++sweep) {
    change = 0;
    for (const std::uint32_t i : order) {
      const auto s = product.state(i);
      float least = INFINITY;
      for (std::uint32_t k = 0; k < product.choices(s); ++k) {
        if (k < remembered ? (judged[i] >> k & 1U) == 0 : !good(s, k)) continue;
        float sum = 1;
        product.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
          if (t != Product::trap) sum += static_cast<float>(p) * steps[t];
        });
        if (sum >= least) continue;
        least = sum;
        strategy.choice.set(i, k);
      }
      change = std::max(change, std::abs(least - steps[i]) / least);
      steps[i] = least;
    }
  }
  return change <= settled;
}

}  // namespace waymark::plan
