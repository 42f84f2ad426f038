// Which states can reach a target, and which can do so almost surely: graph questions, answered exactly.
//
// Product: anything with the public face of ProductMdp. Sets are indexed by state. Backward searches over the
// predecessors that the product enumerates; a choice is looked at again when one of its outcomes joins. O(edges) for
// the first question, O(edges · rounds) for the second, where every round but the last removes states. [BK08, Sec.
// 10.6.1]
#pragma once
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace waymark::plan {

using StateSet = std::vector<bool>;  // by state

// The states from which `targets` are reached when only choices count that `usable(state, choice, reached)` says yes
// to.
template <class Product, class Usable>
StateSet backward(const Product& product, const StateSet& targets, const Usable& usable) {
  StateSet reached = targets;
  std::deque<typename Product::Compact> open;  // first in, first out: some layers of distance, not the set
  product.for_each_state([&](const auto& s) {
    if (targets[s.index]) open.push_back(product.compact(s));
  });
  for (; !open.empty(); open.pop_front()) {
    const auto joined = product.state(open.front());
    product.for_each_predecessor(joined, [&](const auto& source) {
      if (reached[source.index]) return;
      const std::uint32_t choices = product.choices(source);
      for (std::uint32_t k = 0; k < choices; ++k) {
        if (!usable(source, k, reached)) continue;
        reached[source.index] = true;
        open.push_back(product.compact(source));
        return;
      }
    });
  }
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
StateSet can_reach(const Product& product, const StateSet& targets) {
  return backward(product, targets, [&](const auto& s, std::uint32_t k, const StateSet& reached) {
    return some_outcome_in(product, s, k, reached);
  });
}

// No choice leads out of the set: who can reach the targets then cannot but reach them in the end, if he tries.
template <class Product>
bool closed(const Product& product, const StateSet& set) {
  bool out = true;
  product.for_each_state([&](const auto& s) {
    if (!out || !set[s.index]) return;
    for_each_target(product, s, [&](std::uint32_t t) { out = out && t != Product::trap && set[t]; });
  });
  return out;
}

// Takes out what nothing keeps, and what nothing keeps without it, until there is no such state. keeps(state): is it
// out already, or does something keep it in? Asked again when an outcome of one of its choices is taken out.
template <class Product, class Keeps, class TakeOut>
void prune(const Product& product, const Keeps& keeps, const TakeOut& take_out) {
  std::deque<typename Product::Compact> open;
  const auto look_at = [&](const auto& s) {
    if (keeps(s)) return;
    take_out(s);
    open.push_back(product.compact(s));
  };
  product.for_each_state([&](const auto& s) {
    look_at(s);
    for (; !open.empty(); open.pop_front()) product.for_each_predecessor(product.state(open.front()), look_at);
  });
}

// Takes states out of the set that no choice keeps inside, until there are none; targets stay.
template <class Product>
void keep_safe(const Product& product, const StateSet& targets, StateSet& set) {
  prune(
      product,
      [&](const auto& s) {
        bool kept = !set[s.index] || targets[s.index];
        for (std::uint32_t k = 0; k < product.choices(s) && !kept; ++k) kept = all_outcomes_in(product, s, k, set);
        return kept;
      },
      [&](const auto& s) { set[s.index] = false; });
}

struct Reaching {  // states, by a question
  StateSet some;   // from which some strategy reaches the targets with a probability above 0
  StateSet sure;   // … with probability 1
};

// The second is the greatest set from which targets can be reached by choices that never leave the set.
template <class Product>
Reaching reaching(const Product& product, const StateSet& targets) {
  StateSet some = can_reach(product, targets), inside = some;
  while (!closed(product, inside)) {
    keep_safe(product, targets, inside);
    StateSet next = backward(product, targets, [&](const auto& s, std::uint32_t k, const StateSet& reached) {
      if (!inside[s.index]) return false;
      bool all = true, any = false;
      product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) {
        all = all && t != Product::trap && inside[t];
        any = any || (all && reached[t]);
      });
      return all && any;
    });
    if (next == inside) break;
    inside = std::move(next);
  }
  return {std::move(some), std::move(inside)};
}

// The second alone.
template <class Product>
StateSet almost_surely(const Product& product, const StateSet& targets) {
  return reaching(product, targets).sure;
}

}  // namespace waymark::plan
