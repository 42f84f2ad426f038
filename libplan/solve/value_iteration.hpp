// Values of a Markov decision process between proved bounds: optimistic value iteration [HK20, Alg. 2].
//
// From below, values grow in place until they hardly change; then a little is added to all of them, and when one more
// sweep raises none, they are an upper bound: whatever Φ does not raise lies above its least fixpoint, the value. Else
// the iteration from below goes on with a finer measure. Interval iteration, which comes down from 1, does not close
// where a strategy can waste time almost for ever.
//
// Blocks of the product are solved in the order in which outcomes lead, each in the order of distance from what is
// solved, so that a sweep carries news all the way. States between which one can move at will and for nothing have one
// value and are swept as one (`merged`): otherwise they could hold each other up. A choice that may come to nothing is
// taken until it comes to something: its value is divided by the chance that it does.
// Bounds are sound up to the rounding of doubles, as in the tools we compare with.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "libplan/solve/bellman_operator.hpp"
#include "libplan/solve/equations.hpp"
#include "libplan/solve/grid_block.hpp"
#include "libplan/solve/kept_bounds.hpp"
#include "libplan/solve/swept_block.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

struct Values {
  KeptBounds bounds;  // of targets 1 (probability) or 0 (cost)
  std::vector<double>
      attained;  // by state: the bound that some choice attains, the lower one of probabilities
  std::uint64_t sweeps = 0;
};

// What is remembered of states whose block has been solved.
struct Keep {
  const StateSet* bounds =
      nullptr;  // of which states; those that other blocks lead into among them. None: of all
  bool attained = false;
};

template <class Product, Measure measure>
class ValueIteration {
 public:
  // claimed: values by state that blocks of grids may begin with (GridBlock::start_from), or nothing
  ValueIteration(const Product& product, const Unknowns& unknowns, const IterationOptions& limits,
                 const Keep& keep = {}, const std::vector<double>* claimed = nullptr)
      : product_(product),
        unknowns_(unknowns),
        limits_(limits),
        merged_(product, unknowns),
        best_(product, unknowns, merged_),
        claimed_(claimed) {
    values_.bounds = keep.bounds != nullptr ? KeptBounds(*keep.bounds) : KeptBounds(product.states());
    if (keep.attained) values_.attained.assign(product.states(), 0);
  }

  std::optional<Values> run() {  // nullopt: stopped, out of sweeps, or the bounds do not meet in doubles
    begin();
    const std::vector<std::uint32_t>& blocks = product_.blocks();
    for (std::size_t b = 0; b + 1 < blocks.size(); ++b)
      if (!solve_block(blocks[b], blocks[b + 1])) return std::nullopt;
    return std::move(values_);
  }

 private:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  static constexpr double target_value = is_probability(measure) ? 1 : 0;
  // Unknowns are 0 until their block is solved.
  void begin() {
    for (std::uint32_t i = 0; i < product_.states(); ++i)
      if (unknowns_.targets[i]) set(i, target_value, target_value);
  }
  void set(std::uint32_t i, double lower, double upper) {
    values_.bounds.set(i, lower, upper);
    if (!values_.attained.empty()) values_.attained[i] = is_probability(measure) ? lower : upper;
  }
  void set_merged(const State& s, double lower, double upper) {  // with those that have one value with it
    if (const std::uint32_t own = merged_.component(s.index); own == EndComponents::none)
      set(s.index, lower, upper);
    else
      for (const Compact& member : merged_.members(own)) set(product_.state(member).index, lower, upper);
  }
  double lower(std::uint32_t i) const {  // of what is known
    return unknowns_.unknown[i] ? values_.bounds.lower(i) : unknowns_.targets[i] ? target_value : 0;
  }
  double upper(std::uint32_t i) const {
    return unknowns_.unknown[i] ? values_.bounds.upper(i) : unknowns_.targets[i] ? target_value : 0;
  }

  bool solve_block(std::uint32_t first, std::uint32_t last) {
    std::vector<Compact> order = merged_.in_order(first, last);
    if (order.empty()) return true;
    if constexpr (std::is_same_v<Product, GridBlock::Product> ||
                  std::is_same_v<Product, StrategyChain<GridBlock::Product>>)
      if (order.size() > limits_.on_grid && !limits_.policy_iteration) {
        const std::size_t size = order.size();
        if (auto block = grid_block(std::move(order))) {
          if (solve_on_grid(*block)) return true;
          if (size > Equations::factored || limits_.stop.stop_requested()) return false;
        }
        order = merged_.in_order(first, last);
      }
    return order.size() <= limits_.written_out ? solve_equations(order, first, last) : sweep(order);
  }

  std::optional<GridBlock> grid_block(std::vector<Compact> order) const {
    if constexpr (std::is_same_v<Product, GridBlock::Product>)
      return GridBlock::of(product_, unknowns_, measure, std::move(order), values_.bounds);
    else
      return GridBlock::of(product_.product(), unknowns_, measure, std::move(order), values_.bounds,
                           &product_.strategy());
  }

  bool solve_on_grid(GridBlock& block) {
    if (claimed_ != nullptr) block.start_from(*claimed_, limits_.tolerance);
    const auto sweeps = block.solve(limits_);
    if (!sweeps) return false;
    block.for_each([&](std::uint32_t i, double lower, double upper) { set(i, lower, upper); });
    values_.sweeps += *sweeps;
    return true;
  }

  // The rows of the block. Outcomes among merged states come to nothing.
  bool solve_equations(const std::vector<Compact>& order, std::uint32_t first, std::uint32_t last) {
    Equations equations(measure);
    first_ = first;
    row_.assign(last - first, no_row);
    for (std::uint32_t i = 0; i < order.size(); ++i) number(product_.state(order[i]), i);
    for (const Compact& c : order) {
      equations.add_row();
      const State s = product_.state(c);
      if (const std::uint32_t own = merged_.component(s.index); own == EndComponents::none)
        add_choices(s, equations);
      else
        for (const Compact& member : merged_.members(own)) add_choices(product_.state(member), equations);
    }
    const auto solution = equations.solve(limits_);
    if (!solution) return false;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      const State s = product_.state(order[i]);
      set_merged(s, solution->lower[i], solution->upper[i]);
    }
    std::vector<std::uint32_t>().swap(row_);
    values_.sweeps += solution->sweeps;
    return true;
  }

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
                   (is_probability(measure) || unknowns_.unknown[t] || unknowns_.targets[t])) {
          below += p * lower(t);
          above += p * upper(t);
          least_known = std::min(least_known, lower(t));
        } else if (t == Product::trap || row(t) == no_row) {
          counts = counts && is_probability(measure);
        }
      });
      if (!counts) continue;
      const bool leaves = stays < 1 - 1e-12;
      if (!leaves && measure != Measure::MinProbability) continue;
      equations.add_choice();
      const double scale = leaves ? 1 / (1 - stays) : 0;
      product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::trap && row(t) != no_row && row(t) != own) equations.add_term(row(t), p * scale);
      });
      equations.end_choice({below * scale, above * scale, cost * scale, least_known});
    }
  }

  bool sweep(const std::vector<Compact>& order) {
    SweptBlock<Product, measure> block(product_, merged_, best_);
    for (std::uint32_t i = 0; i < product_.states(); ++i)
      if (!unknowns_.unknown[i] || values_.bounds.keeps(i)) block.know(i, lower(i), upper(i));
    const auto sweeps = block.solve(order, limits_);
    if (!sweeps) return false;
    for (const Compact& c : order) {
      const State s = product_.state(c);
      set_merged(s, block.lower(s.index), block.upper(s.index));
    }
    values_.sweeps += *sweeps;
    return true;
  }

  const Product& product_;
  const Unknowns& unknowns_;
  const IterationOptions& limits_;
  const EndComponentQuotient<Product> merged_;
  const BellmanOperator<Product, measure> best_;
  const std::vector<double>* claimed_;
  Values values_;
  static constexpr std::uint32_t no_row = UINT32_MAX;
  std::uint32_t first_ = 0;         // of the block at hand
  std::vector<std::uint32_t> row_;  // of the block at hand, by state
};

}  // namespace waymark::plan
