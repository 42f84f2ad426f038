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
#include "libplan/solve/kept_bounds.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/pipelined_passes.hpp"
#include "libplan/solve/strategy_chain.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

class GridBlock {
 public:
  using Product = ProductMdp<GridWorld>;        // that is swept
  using Order = std::vector<Product::Compact>;  // in which the unknowns of the block are swept

  // `known` holds the bounds of other blocks' entries. With a strategy: of its choices only. `memory` holds the values.
  // nullopt: a block of another kind.
  static std::optional<GridBlock> of(const Product& product, const Unknowns& unknowns, Measure measure, Order order,
                                     const KeptBounds& known, const Strategy* only = nullptr,
                                     std::pmr::memory_resource* memory = std::pmr::get_default_resource());

  // Values to begin with: the bound, by state, that a strategy like this one attains, proved with this tolerance. The
  // nearer to the truth they are, from whichever side, the sooner it is found.
  void start_from(std::span<const double> attained, double tolerance);
  // nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<std::uint64_t> solve(const IterationOptions& options);
  template <class Visit>  // visit(state, lower, upper), once they are solved
  void for_each(Visit&& visit) const {
    for (std::uint32_t cell : cells_)
      visit(product_.state(Product::Compact{cell, task_}).index, lower_[cell + margin_], upper_[cell + margin_]);
  }

  // The backend of optimistic_iteration.hpp.
  std::uint64_t sweeps() const { return sweeps_; }
  bool refine(double change, const IterationOptions& options);
  void guess(double tolerance);
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
  GridBlock(const Product& product, Measure measure, Order order, const Strategy* only,
            std::pmr::memory_resource* memory);
  using Values = std::pmr::vector<double>;  // by cell
  bool read(const Unknowns& unknowns, const KeptBounds& known);
  bool read_cell(std::uint32_t cell, const Unknowns& unknowns, const KeptBounds& known);
  std::uint32_t counted(std::uint32_t open, std::uint32_t good) const;
  void tabulate();
  double chance(std::uint32_t choice, std::uint32_t direction) const;
  std::array<double, 4> around(std::uint32_t cell, const Values& x) const;
  double best(std::uint32_t cell, const Values& x) const;
  double of_strategy(std::uint32_t cell, const Values& x) const;
  struct Around {  // a cell next to the block
    std::uint32_t cell;
    double lower, upper;
  };
  enum class Side : std::uint8_t { Middle, Bounds };
  void set_around(Side side);
  bool bound_by_around(double tolerance);
  void guess_costs();
  void start_from_nothing(bool guess);
  std::size_t chunk_size();
  void make_chunks();
  double likely() const;
  double over_relaxation() const;
  double sweep(std::size_t chunk, double over_relaxation);
  bool close_from_above(std::size_t chunk);
  bool close_from_below(std::size_t chunk);
  template <class Close>
  bool close(const Close& close_chunk, std::uint64_t most, const IterationOptions& options);
  std::size_t chunk_end(std::size_t chunk) const { return std::min(cells_.size(), (chunk + 1) * chunk_size_); }

  const Product& product_;
  Measure measure_;
  const Strategy* only_;              // nullptr: the best choice counts
  std::uint32_t task_ = 0, margin_;   // a row of cells on both sides, so that every cell has neighbours
  std::vector<std::uint32_t> cells_;  // in order
  std::vector<std::uint8_t> code_;    // by cell: bit d, move d is open; bit 4 + k, choice k counts
  std::vector<std::uint8_t>
      known_;  // by cell: bit d, the neighbour that way is known and allowed, or is an unknown of the block
  std::vector<Around> around_;                           // of what is known already, some of them more than once
  std::vector<bool> unknown_;                            // by cell
  std::array<std::array<std::int32_t, 4>, 16> steps_{};  // by open moves: where the neighbour by direction lies
  std::vector<Row> rows_;                                // by code
  std::vector<Only> only_rows_;                          // by code, of strategies
  Values lower_, upper_;
  std::size_t chunk_size_ = 0;  // cells, but for the last chunk; 0: not made yet
  ChunkReach reach_{0};         // of chunks
  double over_relaxation_ = 1;  // what a step is multiplied by
  double chunks_a_sweep_ = 1;   // by which the front moves on
  std::uint64_t sweeps_ = 0;
  bool started_ = false;
};

}  // namespace waymark::plan
