// Of choices that are worth the same, those by which a run ends soonest.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/pipelined_passes.hpp"
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

  // The least expected steps of a state by those of others, and the choice; the change, relative.
  float sweep(std::size_t i, std::vector<float>& steps, std::uint32_t& swiftest) const {
    float least = INFINITY;
    for (std::uint32_t c = first_choice[i]; c < first_choice[i + 1]; ++c) {
      float sum = 1;
      for (std::uint32_t o = first_outcome[c]; o < first_outcome[c + 1]; ++o) sum += probability[o] * steps[target[o]];
      if (sum >= least) continue;
      least = sum;
      swiftest = c;
    }
    const float change = std::abs(least - steps[i]) / least;
    steps[i] = least;
    return change;
  }

  std::size_t states() const { return first_choice.size() - 1; }  // that were written
  // States of four layers, on average: how far news travels in two sweeps. A layer is one outcome farther away.
  std::size_t chunk_size() const {
    std::vector<std::uint32_t> layer(states(), 0);
    std::uint32_t layers = 1;
    for (std::uint32_t i = 0; i < states(); ++i) {
      std::uint32_t nearest = UINT32_MAX;
      for (std::uint32_t o = first_outcome[first_choice[i]]; o < first_outcome[first_choice[i + 1]]; ++o)
        if (target[o] < i) nearest = std::min(nearest, layer[target[o]]);
      layer[i] = nearest == UINT32_MAX ? 0 : nearest + 1;
      layers = std::max(layers, layer[i] + 1);
    }
    return std::max<std::size_t>(64, 4 * states() / layers);
  }
  ChunkReach reach(std::size_t chunk) const {  // of chunks of so many states
    ChunkReach out((states() + chunk - 1) / chunk);
    for (std::size_t i = 0; i < states(); ++i)
      for (std::uint32_t o = first_outcome[first_choice[i]]; o < first_outcome[first_choice[i + 1]]; ++o)
        out.relate(i / chunk, target[o] / chunk);
    return out;
  }
};

// Of the good choices of the unknown states, those by which a run ends soonest: least expected steps, by sweeps until
// these hardly change. Good choices may lead back and forth almost for ever where all that can go wrong lies far away;
// what is lost in a step for want of a digit is then lost in every step of them. `order`: nearest first. False: a
// run of good choices may not end, or there are too many of them. O(outcomes) a sweep.
template <class Product, class Good>
bool hurry(const Product& product, const std::vector<std::uint32_t>& order, const Good& good,
           const IterationOptions& limits, Strategy& strategy) {
  constexpr std::size_t most_sweeps = 4'000;  // of all states: about as many as a run has steps
  constexpr float settled = 2e-4F;
  constexpr std::size_t most_outcomes = 500'000'000;
  GoodChoices written;
  if (!written.write(product, order, good, most_outcomes)) return false;
  std::vector<float> steps(order.size(), 0);
  std::vector<std::uint32_t> swiftest(order.size(), UINT32_MAX);
  const std::size_t size = written.chunk_size();
  const ChunkReach reach = written.reach(size);
  const std::size_t chunks = reach.chunks();
  bool done = false;
  const auto work = [&](std::size_t chunk, const Pass&) {
    const std::size_t first = chunk * size, last = std::min(order.size(), first + size);
    float change = 0;
    for (std::size_t i = first; i < last; ++i) change = std::max(change, written.sweep(i, steps, swiftest[i]));
    return change <= settled;
  };
  // Behind a first front states have settled; a second one moves on as fast as news travels. Then all are swept.
  const auto after = [&, swept = std::size_t{0}, reached = std::size_t{1}, whole = chunks <= 1](
                         const Pass& pass, std::size_t unsettled) mutable -> std::optional<Pass> {
    swept += pass.end - pass.begin;
    done = whole && unsettled == pass.end;
    if (done || swept / std::max<std::size_t>(chunks, 1) >= most_sweeps || limits.stop.stop_requested())
      return std::nullopt;
    whole = whole || unsettled == chunks;
    if (whole) return Pass{0, chunks};
    ++reached;
    return Pass{unsettled, std::clamp((reached + 1) / 2, unsettled + 1, chunks)};
  };
  pipelined_passes(reach, limits.sweepers.free(), {0, std::min<std::size_t>(1, chunks)}, work, after);
  for (std::size_t i = 0; i < order.size(); ++i)
    if (swiftest[i] != UINT32_MAX) strategy.choice.set(order[i], written.choice[swiftest[i]]);
  return done;
}

}  // namespace waymark::plan
