// The unknowns of one block of a grid's product, swept without their equations written out.
//
// All four moves of a cell lead to the same four neighbours, and cells with the same barred moves have the same
// chances: so the equations of a cell are its neighbours' values and a row of a table, of 256 rows at most. Values
// stand where the cells stand, so neighbours need no numbers: 22 bytes a cell, where equations written out take 272
// (probabilities) or 356 (costs). A strategy is swept in the same way, with one choice a cell.
//
// Values are found as it suits: costs from a guess that may be too great, by over-relaxation, with a
// window that moves outwards from what is solved. What holds of them is proved afterwards, on both sides: u with
// Φ(u) ≤ u lies above the least fixpoint of Φ, which is the value [HK20]; l with l ≤ Φ(l) lies below it, since nothing
// is merged here: of probabilities every strategy leaves the unknowns almost surely, of costs the best one does, so
// that l ≤ Φⁿ(l) comes down to the value. Guesses that are not inductive are swept until they are.
// For blocks of one state of the automaton in which a cell is met with one task only, as in tasks of visits and
// avoidance; others are left to Equations.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/grid_strips.hpp"
#include "libplan/solve/kept_bounds.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/side_by_side.hpp"
#include "libplan/solve/strategy_chain.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

class GridBlock {
 public:
  using Product = ProductMdp<GridWorld>;       // that is swept
  using Order = SweepOrder<Product::Compact>;  // of the unknowns of the block

  // With a strategy: of its choices only. `memory` holds the values. nullopt: a block of another kind.
  static std::optional<GridBlock> of(const Product& product, const Unknowns& unknowns, Measure measure, Order order,
                                     const Strategy* only = nullptr,
                                     std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  std::size_t cells() const { return strips_.cells(); }  // unknowns
  void know(const KeptBounds& known);                    // the entries of other blocks: before the block is solved
  // Values to begin with: the bound, by state, that a strategy like this one attains, proved with this tolerance. The
  // nearer to the truth they are, from whichever side, the sooner it is found.
  void start_from(std::span<const double> attained, double tolerance);
  // nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<std::uint64_t> solve(const IterationOptions& options);
  template <class Visit>  // visit(state, lower, upper), once they are solved
  void for_each(Visit&& visit) const {
    strips_.for_each([&](std::uint32_t cell, std::uint32_t slot) { visit(state(cell), lower_[slot], upper_[slot]); });
  }

  // The backend of optimistic_iteration.hpp.
  std::uint64_t sweeps() const { return sweeps_; }
  bool refine(double change, const IterationOptions& options);
  void guess(double tolerance) { gap_ = tolerance / 4; }  // made when it is to be proved
  bool prove(std::uint64_t sweeps, const IterationOptions& options);

 private:
  struct Row {                                    // of a cell with these barred moves and these choices
    std::array<std::array<double, 4>, 4> chance;  // by direction, by choice
    std::array<double, 4> cost;                   // of a choice that does not count: never the best
  };
  struct Only {  // of a cell with these barred moves and this one choice
    std::array<double, 4> chance;
    double cost;
  };
  GridBlock(const Product& product, Measure measure, const Order& order, const Strategy* only,
            std::pmr::memory_resource* memory);
  using Values = GridStrips::Values;  // by slot
  std::uint32_t state(std::uint32_t cell) const { return product_.state(Product::Compact{cell, task_}).index; }
  bool read(const Unknowns& unknowns);
  bool read_cell(std::uint32_t cell, std::uint32_t slot, const Unknowns& unknowns);
  std::uint32_t counted(std::uint32_t open, std::uint32_t good) const;
  void tabulate();
  double chance(std::uint32_t choice, std::uint32_t direction) const;
  std::array<double, 4> around(std::uint32_t slot, const Values& x) const;
  double best(std::uint32_t slot, const Values& x) const;
  double of_strategy(std::uint32_t slot, const Values& x) const;
  struct Around {               // a cell next to the block
    std::uint32_t slot, state;  // no state: a target
    double lower, upper;
  };
  enum class Side : std::uint8_t { Middle, Bounds };
  void set_around(Side side);
  bool bound_by_around(double tolerance);
  void guess_costs();
  void start_from_nothing(bool guess);
  double likely() const;
  double over_relaxation() const;
  double sweep(std::span<const std::uint32_t> slots, double over_relaxation);
  void guess(std::span<const std::uint32_t> slots);
  bool close_from_above(std::span<const std::uint32_t> slots);
  bool close_from_below(std::span<const std::uint32_t> slots);
  template <class Settles, class Next>
  void run(const Pass& first, Values* const& values, const IterationOptions& options, const Settles& settles,
           Next next);

  const Product& product_;
  Measure measure_;
  const Strategy* only_;  // nullptr: the best choice counts
  std::uint32_t task_;
  GridStrips strips_;  // the cells, in order
  std::size_t chunk_size_;
  // By slot: bit d, move d is open; bit 4 + k, choice k counts. And: bit d, the neighbour that way is known and
  // allowed, or is an unknown of the block; is the slot that of an unknown, or of a copy of one?
  std::vector<std::uint8_t> code_, marks_;
  static constexpr std::uint8_t unknown = 16, copy = 32;
  std::vector<Around> around_;                           // of what is known already, some of them more than once
  std::array<std::array<std::int32_t, 4>, 16> steps_{};  // by open moves: where the neighbour by direction lies
  std::vector<Row> rows_;                                // by code
  std::vector<Only> only_rows_;                          // by code, of strategies
  Values lower_, upper_;
  double over_relaxation_ = 1;  // what a step is multiplied by
  double chunks_a_sweep_ = 1;   // by which the front moves on
  double gap_ = 0;              // between a value that is found and a bound that is guessed
  std::uint64_t sweeps_ = 0;
  bool started_ = false;
};

}  // namespace waymark::plan
