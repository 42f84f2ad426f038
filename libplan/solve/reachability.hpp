// Which states can reach a target, and which can do so almost surely: graph questions, answered exactly.
//
// Product: anything with the public face of ProductMdp. Sets are indexed by state. Backward searches over the
// predecessors that the product enumerates; a choice is looked at again when one of its outcomes joins. O(edges) for
// the first question, O(edges · rounds) for the second, where every round but the last removes states. [BK08, Sec. 10.6.1]
#pragma once
#include <cstdint>
#include <vector>

namespace waymark::plan {

using StateSet = std::vector<bool>;

// The states from which `targets` are reached when only choices count that `usable(state, choice, reached)` says yes to.
template <class Product, class Usable>
StateSet backward(const Product& product, const StateSet& targets, const Usable& usable) {
  StateSet reached = targets;
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < product.states(); ++i)
    if (targets[i]) open.push_back(i);
  while (!open.empty()) {
    const auto joined = product.state(open.back());
    open.pop_back();
    product.for_each_predecessor(joined, [&](const auto& source) {
      if (reached[source.index]) return;
      for (std::uint32_t k = 0; k < product.choices(source); ++k) {
        if (!usable(source, k, reached)) continue;
        reached[source.index] = true;
        open.push_back(source.index);
        return;
      }
    });
  }
  return reached;
}

template <class Product>
bool some_outcome_in(const Product& product, const typename Product::State& s, std::uint32_t k,
                     const StateSet& set) {
  bool some = false;
  product.for_each_outcome(
      s, k, [&](std::uint32_t t, double, bool) { some = some || (t != Product::lost && set[t]); });
  return some;
}

template <class Product>
bool all_outcomes_in(const Product& product, const typename Product::State& s, std::uint32_t k,
                     const StateSet& set) {
  bool all = true;
  product.for_each_outcome(s, k,
                           [&](std::uint32_t t, double, bool) { all = all && t != Product::lost && set[t]; });
  return all;
}

// Some strategy reaches the targets with a probability above 0.
template <class Product>
StateSet can_reach(const Product& product, const StateSet& targets) {
  return backward(product, targets, [&](const auto& s, std::uint32_t k, const StateSet& reached) {
    return some_outcome_in(product, s, k, reached);
  });
}

// Some strategy reaches them with probability 1: the greatest set from which they can be reached by choices that never
// leave the set.
template <class Product>
StateSet almost_surely(const Product& product, const StateSet& targets) {
  StateSet inside = can_reach(product, targets);
  while (true) {
    StateSet next = backward(product, targets, [&](const auto& s, std::uint32_t k, const StateSet& reached) {
      return inside[s.index] && all_outcomes_in(product, s, k, inside) &&
             some_outcome_in(product, s, k, reached);
    });
    if (next == inside) return inside;
    inside = std::move(next);
  }
}

}  // namespace waymark::plan
