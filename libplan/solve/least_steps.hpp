// Of choices that are worth the same, those by which a run ends soonest.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "libplan/solve/strategy.hpp"

namespace waymark::plan {

// The good choices of some states, and their outcomes among these, in flat arrays: 8 bytes an outcome, 4 a choice.
struct GoodChoices {
  std::vector<std::uint32_t> first_choice{0}, choice, first_outcome{0}, target;  // targets by place in the order
  std::vector<float> probability;                                                // of each

  // In this order. False: more outcomes than the limit.
  template <class Product, class Good>
  bool write(const Product& product, const std::vector<std::uint32_t>& order, const Good& good, std::size_t limit) {
    std::vector<std::uint32_t> place(product.states(), UINT32_MAX);
    for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    for (const std::uint32_t i : order) {
      const auto s = product.state(i);
      for (std::uint32_t k = 0; k < product.choices(s); ++k) {
        if (!good(s, k)) continue;
        product.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
          if (t == Product::trap || place[t] == UINT32_MAX) return;  // the run ends there
          target.push_back(place[t]);
          probability.push_back(static_cast<float>(p));
        });
        choice.push_back(k);
        first_outcome.push_back(static_cast<std::uint32_t>(target.size()));
      }
      first_choice.push_back(static_cast<std::uint32_t>(choice.size()));
      if (target.size() > limit) return false;
    }
    return true;
  }
};

// Of the good choices of the unknown states, those by which a run ends soonest: least expected steps, by sweeps until
// these hardly change. Good choices may lead back and forth almost for ever where all that can go wrong lies far away;
// what is lost in a step for want of a digit is then lost in every step of them. `order`: nearest first. False: a
// run of good choices may not end, or there are too many of them. O(outcomes) a sweep.
template <class Product, class Good>
bool hurry(const Product& product, const std::vector<std::uint32_t>& order, const Good& good,
           const std::stop_token& stop, Strategy& strategy) {
  constexpr int most_sweeps = 4'000;  // about as many as a run has steps
  constexpr float settled = 2e-4F;
  constexpr std::size_t most_outcomes = 500'000'000;
  GoodChoices written;
  if (!written.write(product, order, good, most_outcomes)) return false;
  std::vector<float> steps(order.size(), 0);
  std::vector<std::uint32_t> swiftest(order.size(), UINT32_MAX);
  float change = INFINITY;
  for (int sweep = 0; sweep < most_sweeps && change > settled && !stop.stop_requested(); ++sweep) {
    change = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      float least = INFINITY;
      for (std::uint32_t c = written.first_choice[i]; c < written.first_choice[i + 1]; ++c) {
        float sum = 1;
        for (std::uint32_t o = written.first_outcome[c]; o < written.first_outcome[c + 1]; ++o)
          sum += written.probability[o] * steps[written.target[o]];
        if (sum >= least) continue;
        least = sum;
        swiftest[i] = c;
      }
      change = std::max(change, std::abs(least - steps[i]) / least);
      steps[i] = least;
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i)
    if (swiftest[i] != UINT32_MAX) strategy.choice.set(order[i], written.choice[swiftest[i]]);
  return change <= settled;
}

}  // namespace waymark::plan
