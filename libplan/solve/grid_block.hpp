// The unknowns of one block of a grid's product, swept without their equations written out.
//
// All four moves of a cell lead to the same four neighbours, and cells with the same barred moves have the same chances:
// so the equations of a cell are its neighbours' values and a row of a table, of 256 rows at most. Values stand where the
// cells stand, so neighbours need no numbers: 22 bytes a cell, where equations written out take 272 (probabilities) or
// 356 (costs). The sweeps, their order and the proof are those of Equations [HK20, Alg. 2]. A strategy is swept in the
// same way, with one choice a cell.
// For blocks of one state of the automaton in which a cell is met with one task only, as in tasks of visits and
// avoidance; others are left to Equations.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/equations.hpp"
#include "libplan/solve/strategy_chain.hpp"
#include "libplan/solve/unknowns.hpp"

namespace waymark::plan {

class GridBlock {
 public:
  using Product = ProductMdp<GridWorld>;
  using Order = std::vector<Product::Compact>;  // in which the unknowns of the block are swept

  // `lower` and `upper` hold what is known of other blocks, by state. With a strategy: of its choices only. nullopt: a
  // block of another kind.
  static std::optional<GridBlock> of(const Product& product, const Unknowns& unknowns, Measure measure,
                                     const Order& order, const std::vector<double>& lower,
                                     const std::vector<double>& upper, const Strategy* only = nullptr);

  // Bounds to begin with, by state, of costs. The lower ones are taken if no sweep would lower one: of a strategy that
  // is sure to arrive they are lower bounds then. The upper ones are tried first if they are close enough.
  void start_from(const std::vector<double>& lower, const std::vector<double>& upper);
  // nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<std::uint64_t> solve(const IterationLimits& limits);
  double lower(std::uint32_t cell) const { return lower_[cell + margin_]; }
  double upper(std::uint32_t cell) const { return upper_[cell + margin_]; }

 private:
  struct Row {                                    // of a cell with these barred moves and these choices
    std::array<std::array<double, 4>, 4> chance;  // by direction, by choice
    std::array<double, 4> cost;                   // of a choice that does not count: never the best
  };
  struct Only {  // of a cell with these barred moves and this one choice
    std::array<double, 4> chance;
    double cost;
  };
  GridBlock(const Product& product, Measure measure, const Order& order, const Strategy* only);
  bool read(const Unknowns& unknowns, const std::vector<double>& lower, const std::vector<double>& upper);
  bool read_cell(std::uint32_t cell, const Unknowns& unknowns, const std::vector<double>& lower,
                 const std::vector<double>& upper);
  std::uint32_t counted(std::uint32_t open, std::uint32_t good) const;
  void tabulate();
  double chance(std::uint32_t choice, std::uint32_t direction) const;
  std::array<double, 4> around(std::uint32_t cell, const std::vector<double>& x) const;
  double best(std::uint32_t cell, const std::vector<double>& x) const;
  double of_strategy(std::uint32_t cell, const std::vector<double>& x) const;
  void start_from_best_luck();
  double raise();
  bool close_from_above();
  void guess_above(double tolerance);
  bool closer_than(double tolerance) const;
  bool prove(std::uint64_t sweeps);

  const Product& product_;
  Measure measure_;
  const Strategy* only_;              // nullptr: the best choice counts
  std::uint32_t task_ = 0, margin_;   // a row of cells on both sides, so that every cell has neighbours
  std::vector<std::uint32_t> cells_;  // in order
  std::vector<std::uint8_t> code_;    // by cell: bit d, move d is open; bit 4 + k, choice k counts
  std::vector<std::uint8_t>
      known_;  // by cell: bit d, the neighbour that way is known and allowed, or is an unknown of the block
  std::vector<bool> unknown_;    // by cell
  std::vector<Row> rows_;        // by code
  std::vector<Only> only_rows_;  // by code, of strategies
  std::vector<double> lower_, upper_;
  std::uint64_t sweeps_ = 0;
  bool started_ = false;
};

}  // namespace waymark::plan
