#include "libplan/solve/greatest_cost.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "libplan/solve/reachability.hpp"

namespace waymark::plan {
namespace {

// States without a goal, their choices and outcomes in flat arrays; outcomes in goals are left out: they cost nothing
// any more.
template <class Product>
struct Written {
  explicit Written(const Product& product) {
    first_choice.push_back(0);
    first_outcome.push_back(0);
    product.for_each_state([&](const auto& s) {
      for (std::uint32_t k = 0; !product.is_goal(s) && k < product.choices(s); ++k) {
        cost.push_back(product.cost(s, k));
        product.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
          if (product.is_goal(product.state(t))) return;
          target.push_back(t);
          probability.push_back(p);
        });
        first_outcome.push_back(target.size());
      }
      first_choice.push_back(cost.size());
    });
  }

  double best(std::size_t s, const std::vector<double>& values) const {
    double out = 0;
    for (std::size_t c = first_choice[s]; c < first_choice[s + 1]; ++c) {
      double sum = cost[c];
      for (std::size_t o = first_outcome[c]; o < first_outcome[c + 1]; ++o) sum += probability[o] * values[target[o]];
      out = std::max(out, sum);
    }
    return out;
  }

  // In place, in the order of numbers: no outcome leads to a higher range of them. The greatest relative rise.
  double sweep(std::vector<double>& values) const {
    double change = 0;
    for (std::size_t s = 0; s < values.size(); ++s) {
      const double now = best(s, values);
      change = std::max(change, now > values[s] ? (now - values[s]) / now : 0);
      values[s] = now;
    }
    return change;
  }

  // Is no value raised? Those that would fall do.
  bool holds(std::vector<double>& values) const {
    bool out = true;
    for (std::size_t s = 0; s < values.size(); ++s) {
      const double now = best(s, values);
      out = out && !raises(values[s], now);
      values[s] = std::min(values[s], now);
    }
    return out;
  }

  std::vector<std::size_t> first_choice, first_outcome;
  std::vector<double> cost, probability;
  std::vector<std::uint32_t> target;
};

// From which some strategy has a chance never to reach a goal: it stays among states without one, or enters the trap.
template <class Product>
StateSet may_miss(const Product& product) {
  StateSet open(product.states());
  product.for_each_state([&](const auto& s) { open.set(s.index, !product.is_goal(s)); });
  StateSet missed = open;
  keep_safe(product, StateSet(product.states(), false), missed);
  product.for_each_state([&](const auto& s) {
    if (open[s.index] && product.choices(s) == 0) missed.insert(s.index);  // the run ends
    for (std::uint32_t k = 0; open[s.index] && k < product.choices(s); ++k)
      product.for_each_outcome(s, k, [&](std::uint32_t t, double, bool) {
        if (t == Product::trap) missed.insert(s.index);
      });
  });
  return backward(product, missed, [&](const auto& s, std::uint32_t k, const StateSet& reached) {
    return open[s.index] && some_outcome_in(product, s, k, reached);
  });
}

}  // namespace

template <class Model>
std::optional<Bounds> greatest_cost(const ProductMdp<Model>& product, const IterationOptions& limits) {
  if (product.starts().empty()) return Bounds{INFINITY, INFINITY};
  const StateSet missed = may_miss(product);
  if (std::any_of(product.starts().begin(), product.starts().end(), [&](std::uint32_t s) { return missed[s]; }))
    return Bounds{INFINITY, INFINITY};
  // Nothing lies behind a goal: no state that is numbered misses one, and no outcome leads into the trap.
  const Written<ProductMdp<Model>> written(product);
  std::vector<double> lower(product.states(), 0);
  const auto start = [&](const std::vector<double>& values) {
    double out = 0;
    for (const std::uint32_t s : product.starts()) out = std::max(out, values[s]);
    return out;
  };
  std::uint64_t sweeps = 0;
  const auto spent = [&] { return ++sweeps > limits.sweeps || limits.stop.stop_requested(); };
  for (double change = limits.tolerance;; change = change < 1e-18 ? 0 : change / 64) {
    const std::uint64_t before = sweeps;
    while (written.sweep(lower) > change)
      if (spent()) return std::nullopt;
    std::vector<double> upper = lower;
    for (double& value : upper) value *= 1 + limits.tolerance;
    for (std::uint64_t i = 0, most = sweeps - before + 8; i < most; ++i) {
      if (written.holds(upper)) return Bounds{start(lower), start(upper)};
      if (spent()) return std::nullopt;
    }
    if (change == 0) return std::nullopt;
  }
}

template std::optional<Bounds> greatest_cost(const ProductMdp<Mdp>&, const IterationOptions&);
template std::optional<Bounds> greatest_cost(const ProductMdp<GridWorld>&, const IterationOptions&);

}  // namespace waymark::plan
