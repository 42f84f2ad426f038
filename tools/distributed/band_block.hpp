// The own unknowns of a band in one component of the automaton, and their sweeps.
//
// The equations of an unknown are the pairs around it and a row of a table, of 256 rows at most (as in
// libplan/solve/grid_block.hpp): 17 bytes and its place in the order. Sweeps are in place, so values spread along the
// order within one sweep. Unknowns stand in chunks; a chunk is swept again when something that it reads has changed.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tools/distributed/band_sets.hpp"

namespace waymark::tools {

enum class SweepKind : std::uint8_t {
  Distance,   // down to the least sum of steps, if every move went where one would wish
  Below,      // values only rise
  Free,       // values follow the operator both ways
  FromAbove,  // a candidate for an upper bound: fails where it is raised by more than the rounding of a sum
  FromBelow,  // of costs, a candidate for a lower bound: fails where it is lowered
};

struct SweepResult {
  double change = 0;          // the greatest, as the measure counts it
  bool failed = false;        // of a candidate: it is not inductive yet
  std::uint64_t updates = 0;  // of unknowns
};

class BandBlock {
 public:
  // Of automaton states [first, last). `discount`: 1 for the other measures. Product and sets must outlive it.
  BandBlock(const BandProduct& product, const BandSets& sets, SharedMeasure measure, double discount,
            std::uint32_t first, std::uint32_t last);

  const std::vector<std::uint32_t>& unknowns() const { return pairs_; }  // in the order of sweeps

  // Unknowns of the least values come first from now on, so that a front can move on from them.
  void sort_by(const double* values);
  double nearest() const { return depth_.empty() ? INFINITY : depth_.front(); }  // the least value, then
  double deepest() const { return depth_.empty() ? 0 : depth_.back(); }          // the least of the last chunk
  double step() const { return step_; }  // of Distance: the cost of a move, times what slips take back

  // `values`: of all pairs of the product, and a 0 behind them.
  void touch_all();  // every chunk is to be swept
  // What reads a halo value that changed by more since the last touch.
  void touch(const double* values, SweepKind kind, double least);
  void relax_no_more() { over_relaxation_ = 1; }
  bool has_work(double front) const;  // is a chunk to be swept?
  // Sweeps the chunks once that are to be swept and begin before the front. A change of more than `least` has what
  // reads it swept again.
  SweepResult sweep(double* values, SweepKind kind, double least, double front);

 private:
  struct Row {                                    // of these barred moves and these choices
    std::array<std::array<double, 4>, 4> chance;  // by direction, by choice
    std::array<double, 4> cost;                   // of a choice that does not count: never the best
  };
  static constexpr std::size_t chunk_size = 256;  // unknowns

  void read(const BandSets& sets);
  std::uint8_t code(std::uint32_t pair, std::array<std::uint32_t, 4>& to, const BandSets& sets) const;
  void tabulate(double discount);
  void find_readers();
  double best(std::size_t unknown, const double* values) const;
  double nearest(std::size_t unknown, const double* values) const;
  double difference(double before, double after, SweepKind kind) const;
  bool is_cost() const { return measure_ == SharedMeasure::MinCost; }

  const BandProduct* product_;
  SharedMeasure measure_;
  std::uint32_t first_, last_;
  bool jumps_ = false;                                // has some state of the component one?
  std::vector<std::uint32_t> pairs_;                  // in order
  std::vector<std::array<std::uint32_t, 4>> around_;  // by unknown: what stands in each direction
  std::vector<std::uint8_t> code_;                    // by unknown: bit d, direction d leads away; bit 4 + k, k counts
  std::vector<Row> rows_;                             // by code
  std::vector<std::vector<std::uint32_t>> readers_;   // by chunk: the chunks that read it
  std::vector<std::uint32_t> halo_;                   // what is read there
  std::vector<double> halo_values_;                   // … at the last touch
  std::vector<std::uint32_t> first_reader_;           // … by which chunks: the first of these
  std::vector<std::uint32_t> halo_readers_;
  std::vector<std::uint8_t> dirty_;  // by chunk
  std::vector<double> depth_;        // by chunk: where it was sorted, its least value; else 0
  double step_ = 0, over_relaxation_ = 1;
};

}  // namespace waymark::tools
