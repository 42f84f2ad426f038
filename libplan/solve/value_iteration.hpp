// Values of a Markov decision process between proved bounds: optimistic value iteration [HK20, Alg. 2].
//
// Values grow from below, in place, until they hardly change. Then all are raised a little; when one more sweep raises
// none of them, they are upper bounds: what Φ does not raise lies above its least fixpoint, the value. Otherwise
// iteration from below goes on with a finer measure. Interval iteration, which comes down from 1, does not converge
// where a strategy can waste time almost for ever.
//
// Blocks of the product are solved in the order in which outcomes lead, nearest to solved states first. States of one
// end component are swept as one (`merged`). An outcome that changes nothing is divided out. Sound up to rounding.
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libplan/solve/bellman_operator.hpp"
#include "libplan/solve/block_equations.hpp"
#include "libplan/solve/grid_block.hpp"
#include "libplan/solve/kept_bounds.hpp"
#include "libplan/solve/ready_blocks.hpp"
#include "libplan/solve/swept_block.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

template <class Product, Measure measure>
class ValueIteration {
 public:
  // claimed: values by state that blocks of grids may begin with (GridBlock::start_from), or none
  ValueIteration(const Product& product, const Unknowns& unknowns, const IterationOptions& limits,
                 const Keep& keep = {}, std::span<const double> claimed = {})
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
    for (std::uint32_t i = 0; i < product_.states(); ++i)
      if (unknowns_.targets[i]) set(i, target_value, target_value);  // unknowns are 0 until their block is solved
    const ReadyBlocks<Product, measure> blocks(product_, unknowns_, merged_, limits_);
    for (std::size_t b = 0; b + 1 < product_.blocks().size();)
      for (Ready& block : blocks.some(b)) {
        if (!solve_block(block, b++)) return std::nullopt;
        block.grid.reset();
      }
    return std::move(values_);
  }

 private:
  using State = typename Product::State;
  using Compact = typename Product::Compact;

  static constexpr double target_value = is_probability(measure) ? 1 : 0;
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
  using Ready = typename ReadyBlocks<Product, measure>::Ready;
  bool solve_block(Ready& block, std::size_t b) {
    const std::uint32_t first = product_.blocks()[b], last = product_.blocks()[b + 1];
    if (block.grid) {
      const bool another_way = block.grid->cells() <= Equations::factored && limits_.second_way;
      if (solve_on_grid(*block.grid, another_way)) return true;
      if (!another_way || limits_.stop.stop_requested()) return false;
      block.grid.reset();
      block.order = merged_.in_order(first, last);
    }
    const std::vector<Compact>& states = block.order.states;
    if (states.empty()) return true;
    return states.size() <= limits_.written_out ? solve_equations(states, first, last) : sweep(states);
  }

  bool solve_on_grid(GridBlock& block, bool another_way) {
    // Sweeps; where they crawl, equations are solved sooner, though factors of large blocks cost more.
    const std::uint64_t patience = block.cells() > 20'000 ? 4'000 : 1'000;
    IterationOptions limits = limits_;
    if (another_way) limits.sweeps = std::min(limits.sweeps, patience);
    block.know(values_.bounds);
    if (!claimed_.empty()) block.start_from(claimed_, limits.tolerance);
    const auto sweeps = block.solve(limits);
    if (!sweeps) return false;
    block.for_each([&](std::uint32_t i, double lower, double upper) { set(i, lower, upper); });
    values_.sweeps += *sweeps;
    return true;
  }

  bool solve_equations(const std::vector<Compact>& order, std::uint32_t first, std::uint32_t last) {
    const KnownValues known{unknowns_, values_.bounds, target_value};
    const auto solution = BlockEquations<Product, measure>(product_, merged_, known, first, last).solve(order, limits_);
    if (!solution) return false;
    for (std::uint32_t i = 0; i < order.size(); ++i)
      set_merged(product_.state(order[i]), solution->lower[i], solution->upper[i]);
    values_.sweeps += solution->sweeps;
    return true;
  }

  bool sweep(const std::vector<Compact>& order) {
    const KnownValues known{unknowns_, values_.bounds, target_value};
    SweptBlock<Product, measure> block(product_, merged_, best_);
    for (std::uint32_t i = 0; i < product_.states(); ++i)
      if (!unknowns_.unknown[i] || values_.bounds.keeps(i)) block.know(i, known.lower(i), known.upper(i));
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
  const std::span<const double> claimed_;
  Values values_{{}, std::pmr::vector<double>(limits_.memory)};
};

}  // namespace waymark::plan
