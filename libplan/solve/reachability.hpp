// Which states can reach a target, and which can do so almost surely: graph questions, answered exactly.
//
// Product: anything with the public face of ProductMdp. Sets are indexed by state. Backward searches over the
// predecessors that the product enumerates; a choice is looked at again when one of its outcomes joins. O(edges) for
// the first question, O(edges · rounds) for the second, where every round but the last removes states. [BK08, Sec.
// 10.6.1]
//
// Sets that only grow, or only shrink, do not depend on the order of a search: large products are searched by several
// threads.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "libplan/solve/spread.hpp"
#include "libplan/solve/state_set.hpp"

namespace waymark::plan {

// The states from which `targets` are reached when only choices count that `usable(state, choice, reached)` says yes
// to. One that says so keeps to it when more is reached.
template <class Product, class Usable>
StateSet backward(const Product& product, const StateSet& targets, const Usable& usable, std::size_t threads = 1) {
  StateSet reached = targets;
  const bool alone = StateRanges{product.states()}.threads(threads) == 1;
  const auto joins = [&](const auto& source) {
    if (reached[source.index]) return false;
    bool one = false;
    for (std::uint32_t k = 0, choices = product.choices(source); k < choices && !one; ++k)
      one = usable(source, k, reached);
    if (one && !alone) return reached.join(source.index);
    if (one) reached.insert(source.index);
    return one;
  };
  spread(
      product, threads, [&](const auto& s) { return targets[s.index]; }, joins);
  return reached;
}

// visit(state or trap): where some choice may lead, some more than once.
template <class Product, class Visit>
void for_each_target(const Product& product, const typename Product::State& s, Visit&& visit) {
  if constexpr (requires { product.for_each_target(s, visit); }) {
    product.for_each_target(s, visit);
  } else {
    const std::uint32_t choices = product.choices(s);
    for (std::uint32_t k = 0; k < choices; ++k)
      product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) { visit(t); });
  }
}

// Does the choice lead into the set with some chance?
template <class Product>
bool some_outcome_in(const Product& product, const typename Product::State& s, std::uint32_t k, const StateSet& set) {
  bool some = false;
  product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) { some = some || (t != Product::trap && set[t]); });
  return some;
}

// Does the choice lead into the set whatever happens?
template <class Product>
bool all_outcomes_in(const Product& product, const typename Product::State& s, std::uint32_t k, const StateSet& set) {
  bool all = true;
  product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) { all = all && t != Product::trap && set[t]; });
  return all;
}

// Some strategy reaches the targets with a probability above 0.
template <class Product>
StateSet can_reach(const Product& product, const StateSet& targets, std::size_t threads = 1) {
  const auto some = [&](const auto& s, std::uint32_t k, const StateSet& reached) {
    return some_outcome_in(product, s, k, reached);
  };
  return backward(product, targets, some, threads);
}

// No choice leads out of the set: who can reach the targets then cannot but reach them in the end, if he tries.
template <class Product>
bool closed(const Product& product, const StateSet& set, std::size_t threads = 1) {
  std::atomic<bool> out{true};
  for_each_state(product, threads, [&](const auto& s) {
    if (!set[s.index] || !out.load(std::memory_order_relaxed)) return;
    for_each_target(product, s, [&](std::uint32_t t) {
      if (t == Product::trap || !set[t]) out.store(false, std::memory_order_relaxed);
    });
  });
  return out;
}

// Takes states out of the set that nothing keeps inside, and what nothing keeps without them, until there are none.
// keeps(state in the set): asked again when an outcome of one of its choices is taken out.
template <class Product, class Keeps>
void prune(const Product& product, StateSet& set, const Keeps& keeps, std::size_t threads = 1) {
  const auto leaves = [&](const auto& s) { return set[s.index] && !keeps(s) && set.leave(s.index); };
  spread(product, threads, leaves, leaves);
}

// Takes states out of the set that no choice keeps inside, until there are none; targets stay.
template <class Product>
void keep_safe(const Product& product, const StateSet& targets, StateSet& set, std::size_t threads = 1) {
  const auto keeps = [&](const auto& s) {
    bool kept = targets[s.index];
    for (std::uint32_t k = 0; k < product.choices(s) && !kept; ++k) kept = all_outcomes_in(product, s, k, set);
    return kept;
  };
  prune(product, set, keeps, threads);
}

struct Reaching {  // states, by a question
  StateSet some;   // from which some strategy reaches the targets with a probability above 0
  StateSet sure;   // … with probability 1
};

// The second is the greatest set from which targets can be reached by choices that never leave the set.
template <class Product>
Reaching reaching(const Product& product, const StateSet& targets, std::size_t threads = 1) {
  StateSet some = can_reach(product, targets, threads), inside = some;
  while (!closed(product, inside, threads)) {
    keep_safe(product, targets, inside, threads);
    const auto usable = [&](const auto& s, std::uint32_t k, const StateSet& reached) {
      if (!inside[s.index]) return false;
      bool all = true, any = false;
      product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) {
        all = all && t != Product::trap && inside[t];
        any = any || (all && reached[t]);
      });
      return all && any;
    };
    StateSet next = backward(product, targets, usable, threads);
    if (next == inside) break;
    inside = std::move(next);
  }
  return {std::move(some), std::move(inside)};
}

// The second alone.
template <class Product>
StateSet almost_surely(const Product& product, const StateSet& targets, std::size_t threads = 1) {
  return reaching(product, targets, threads).sure;
}

}  // namespace waymark::plan
