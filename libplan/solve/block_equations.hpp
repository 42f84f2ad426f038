// A block of a product as equations: one row for each unknown, outcomes inside an end component left out.
//
// An outcome into another block, or to a target, adds a constant: bounds of a value that is known already.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/solve/equations.hpp"
#include "libplan/solve/kept_bounds.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

struct KnownValues {  // both must outlive it
  // What is asked, and what is known.
  const Unknowns& unknowns;
  const KeptBounds& bounds;
  double target_value;  // 1 (probability) or 0 (cost)

  // Bounds of what is known.
  double lower(std::uint32_t i) const {
    return unknowns.unknown[i] ? bounds.lower(i) : unknowns.targets[i] ? target_value : 0;
  }
  double upper(std::uint32_t i) const {
    return unknowns.unknown[i] ? bounds.upper(i) : unknowns.targets[i] ? target_value : 0;
  }
};

template <class Product, Measure measure>
class BlockEquations {  // all of them must outlive it
 public:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  // The block is the range [first, last) of states.
  BlockEquations(const Product& product, const EndComponentQuotient<Product>& merged, const KnownValues& known,
                 std::uint32_t first, std::uint32_t last)
      : product_(product), merged_(merged), known_(known), first_(first), row_(last - first, no_row) {}

  // By unknown, in that order. nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  auto solve(const std::vector<Compact>& order, const IterationOptions& limits) {
    Equations equations(measure);
    for (std::uint32_t i = 0; i < order.size(); ++i) number(product_.state(order[i]), i);
    for (const Compact& c : order) {
      equations.add_row();
      const State s = product_.state(c);
      if (const std::uint32_t own = merged_.component(s.index); own == EndComponents::none)
        add_choices(s, equations);
      else
        for (const Compact& member : merged_.members(own)) add_choices(product_.state(member), equations);
    }
    return equations.solve(limits);
  }

 private:
  void number(const State& s, std::uint32_t row) {
    if (const std::uint32_t own = merged_.component(s.index); own == EndComponents::none)
      row_[s.index - first_] = row;
    else
      for (const Compact& member : merged_.members(own)) row_[product_.state(member).index - first_] = row;
  }

  std::uint32_t row(std::uint32_t i) const {  // of states outside the block there is none
    return i - first_ < row_.size() ? row_[i - first_] : no_row;
  }
  void add_choices(const State& s, Equations& equations) const {
    const std::uint32_t own = row(s.index), choices = product_.choices(s);
    for (std::uint32_t k = 0; k < choices; ++k) {
      const double cost = measure == Measure::MinCost ? product_.cost(s, k) : 0;
      double below = cost, above = cost, stays = 0, least_known = INFINITY;
      bool counts = true;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::trap && row(t) == own) {
          stays += p;
        } else if (t != Product::trap && row(t) == no_row &&
                   (is_probability(measure) || known_.unknowns.unknown[t] || known_.unknowns.targets[t])) {
          below += p * known_.lower(t);
          above += p * known_.upper(t);
          least_known = std::min(least_known, known_.lower(t));
        } else if (t == Product::trap || row(t) == no_row) {
          counts = counts && is_probability(measure);
        }
      });
      if (!counts) continue;
      if (!(stays < 1 - 1e-12)) continue;
      equations.add_choice();
      const double scale = 1 / (1 - stays);
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::trap && row(t) != no_row && row(t) != own) equations.add_term(row(t), p * scale);
      });
      equations.end_choice({below * scale, above * scale, cost * scale, least_known});
    }
  }

  static constexpr std::uint32_t no_row = UINT32_MAX;
  const Product& product_;
  const EndComponentQuotient<Product>& merged_;
  const KnownValues& known_;
  std::uint32_t first_;
  std::vector<std::uint32_t> row_;  // of the block, by state
};

}  // namespace waymark::plan
