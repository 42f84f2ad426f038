// Of choices that are worth the same, those by which a run ends soonest.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "libplan/solve/exchange.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/ordered_parts.hpp"
#include "libplan/solve/side_by_side.hpp"
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

  // Outcomes in other parts lead to copies then, whose places are behind those of the states.
  std::vector<PlaceOfCopy> copy_between(const OrderedParts& parts) {
    std::vector<PlaceOfCopy> copies;
    std::vector<std::uint32_t> copy_of(states(), UINT32_MAX);  // for the part at hand
    for (std::uint32_t p = 0; p < parts.count(); ++p) {
      const std::size_t others = copies.size();
      for (std::uint32_t o = first_outcome[first_choice[parts.begin[p]]];
           o < first_outcome[first_choice[parts.begin[p + 1]]]; ++o) {
        const std::uint32_t t = target[o];
        if (t >= parts.begin[p] && t < parts.begin[p + 1]) continue;
        if (copy_of[t] == UINT32_MAX) {
          const std::uint32_t owner = parts.part(t);
          copy_of[t] = static_cast<std::uint32_t>(states() + copies.size());
          copies.push_back({owner, p, parts.chunk(owner, t), t, copy_of[t]});
        }
        target[o] = copy_of[t];
      }
      for (std::size_t c = others; c < copies.size(); ++c) copy_of[copies[c].from] = UINT32_MAX;
    }
    return copies;
  }
};

// Of the good choices of the unknown states, those by which a run ends soonest: least expected steps, by sweeps until
// these hardly change. Good choices may lead back and forth almost for ever where all that can go wrong lies far away;
// what is lost in a step for want of a digit is then lost in every step of them. `order`: nearest first. False: a
// run of good choices may not end, or there are too many of them. O(outcomes) a sweep.
template <class Product, class Good>
bool hurry(const Product& product, const SweepOrder<std::uint32_t>& order, const Good& good,
           const IterationOptions& limits, Strategy& strategy) {
  constexpr std::size_t most_sweeps = 4'000;  // of all states: about as many as a run has steps
  constexpr float settled = 2e-4F;
  constexpr std::size_t most_outcomes = 500'000'000;
  const OrderedParts parts = OrderedParts::of(product, order);
  GoodChoices written;
  if (!written.write(product, parts.states, good, most_outcomes)) return false;
  std::vector<PlaceOfCopy> copies = written.copy_between(parts);
  std::vector<float> steps(parts.states.size() + copies.size(), 0);
  std::vector<std::uint32_t> swiftest(parts.states.size(), UINT32_MAX);
  const std::size_t chunks = parts.chunks;
  Exchange<float> exchange(parts.count(), chunks, std::move(copies));
  bool done = false;
  const auto work = [&](std::size_t part, const PassInTurn& now) {
    const Pass& pass = now.pass;
    exchange.take(part, now, steps);
    std::size_t unsettled = pass.end;
    const std::vector<std::uint32_t>& first = parts.first[part];
    for (std::size_t chunk = pass.begin; chunk < pass.end; ++chunk) {
      float change = 0;
      for (std::size_t i = first[chunk], last = first[chunk + 1]; i < last; ++i)
        change = std::max(change, written.sweep(i, steps, swiftest[i]));
      if (!(change <= settled)) unsettled = std::min(unsettled, chunk);
    }
    exchange.tell(part, now, steps);
    return unsettled;
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
  passes_side_by_side(parts.count(), limits.sweepers.free(), {0, std::min<std::size_t>(1, chunks)}, work, after);
  for (std::size_t i = 0; i < parts.states.size(); ++i)
    if (swiftest[i] != UINT32_MAX) strategy.choice.set(parts.states[i], written.choice[swiftest[i]]);
  return done;
}

}  // namespace waymark::plan
