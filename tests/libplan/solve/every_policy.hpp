// What the policies of a small product come to, every one of them, one by one.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/libplan/solve/small_products.hpp"

namespace waymark::plan::testing {

using Policy = std::vector<std::size_t>;  // the choice, by state

// visit(policy): each of them; of targets and of states without a choice the first.
template <class Visit>
void for_each_policy(const SmallProduct& product, const StateSet& targets, Visit&& visit) {
  Policy policy(product.states(), 0);
  while (true) {
    visit(policy);
    std::uint32_t i = 0;
    for (; i < product.states(); ++i) {
      if (!targets[i] && ++policy[i] < product.of[i].size()) break;
      policy[i] = 0;
    }
    if (i == product.states()) return;
  }
}

// x = A x + b by elimination, where that has one solution.
inline std::vector<double> fixpoint(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a[i][j] = (i == j ? 1.0 : 0.0) - a[i][j];
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(a[r][c]) > std::abs(a[pivot][c])) pivot = r;
    std::swap(a[c], a[pivot]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double factor = a[r][c] / a[c][c];
      for (std::size_t j = c; j < n; ++j) a[r][j] -= factor * a[c][j];
      b[r] -= factor * b[c];
    }
  }
  for (std::size_t i = 0; i < n; ++i) b[i] /= a[i][i];
  return b;
}

struct PolicyValues {                // by state
  std::vector<double> chance, cost;  // that a target is reached; what it costs until then, ∞ unless that is sure
};

inline PolicyValues values_of(const SmallProduct& product, const StateSet& targets, const Policy& policy) {
  const std::uint32_t n = product.states();
  const auto grow = [&](StateSet set) {  // by those that may come into it
    for (std::uint32_t round = 0; round < n; ++round)
      for (std::uint32_t i = 0; i < n; ++i)
        if (!set[i] && !targets[i] && !product.of[i].empty())
          for (const SmallProduct::Outcome& o : product.of[i][policy[i]].outcomes)
            if (o.target != SmallProduct::trap && set[o.target]) set.insert(i);
    return set;
  };
  const StateSet some = grow(targets);
  StateSet lost(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    lost.set(i, !some[i]);
    if (some[i] && !targets[i])
      for (const SmallProduct::Outcome& o : product.of[i][policy[i]].outcomes)
        if (o.target == SmallProduct::trap) lost.insert(i);
  }
  const StateSet unsure = grow(lost);
  const std::vector<std::vector<double>> nothing(n, std::vector<double>(n, 0));
  std::vector<std::vector<double>> chances = nothing, moves = nothing;
  std::vector<double> reached(n, 0), costs(n, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (targets[i]) reached[i] = 1;
    if (targets[i] || !some[i]) continue;
    if (!unsure[i]) costs[i] = product.of[i][policy[i]].cost;
    for (const SmallProduct::Outcome& o : product.of[i][policy[i]].outcomes) {
      if (o.target == SmallProduct::trap) continue;
      chances[i][o.target] += o.probability;
      if (!unsure[i]) moves[i][o.target] += o.probability;
    }
  }
  PolicyValues out{fixpoint(chances, reached), fixpoint(moves, costs)};
  for (std::uint32_t i = 0; i < n; ++i)
    if (unsure[i]) out.cost[i] = INFINITY;
  return out;
}

// The greatest chance and the least cost of each state, over all policies.
inline PolicyValues best_values(const SmallProduct& product, const StateSet& targets) {
  PolicyValues out{std::vector<double>(product.states(), 0), std::vector<double>(product.states(), INFINITY)};
  for_each_policy(product, targets, [&](const Policy& policy) {
    const PolicyValues found = values_of(product, targets, policy);
    for (std::uint32_t i = 0; i < product.states(); ++i) {
      out.chance[i] = std::max(out.chance[i], found.chance[i]);
      out.cost[i] = std::min(out.cost[i], found.cost[i]);
    }
  });
  return out;
}

}  // namespace waymark::plan::testing
