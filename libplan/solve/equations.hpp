// The optimality equations of the unknowns of one block, written out, and two ways to solve them between bounds.
//
//   x_i = best over the choices c of i of  constant(c) + Σ coefficient(t) · x_unknown(t)
//
// What is known already is in the constants, of which there are two, for the lower and for the upper bound. A choice
// that may come to nothing is taken until it comes to something: its row is divided by the chance that it does.
// Twelve bytes a term; blocks of many unknowns are better swept without being written out (value_iteration.hpp).
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/pipelined_passes.hpp"

namespace waymark::plan {

class Equations {
 public:
  static constexpr std::uint32_t factored = 100'000;  // rows up to which LU factors are made
  explicit Equations(Measure measure) : measure_(measure) {}

  // Row after row, choice after choice, in the order in which they are to be swept.
  void add_row() { first_choice_.push_back(choices()); }
  void add_choice() { first_term_.push_back(static_cast<std::uint32_t>(unknown_.size())); }
  void add_term(std::uint32_t unknown, double coefficient) {
    unknown_.push_back(unknown);
    coefficient_.push_back(coefficient);
  }
  // cost: what the choice costs by itself, part of the constants; least_known: the least value of what is known among
  // its outcomes, ∞ when there is nothing.
  struct Constants {
    // Below, above: with the lower and the upper bounds of what is known.
    double below = 0, above = 0, cost = 0, least_known = 0;
  };
  void end_choice(const Constants& constants) {  // of the row that was begun
    constant_[0].push_back(constants.below);
    constant_[1].push_back(constants.above);
    if (measure_ != Measure::MinCost) return;
    cost_.push_back(constants.cost);
    least_known_.push_back(constants.least_known);
  }

  struct Solution {                    // bounds of the unknowns
    std::vector<double> lower, upper;  // by row
    std::uint64_t sweeps = 0;          // until they were proved
  };
  // Optimistic value iteration [HK20, Alg. 2]; what is slow to settle, and everything when limits.policy_iteration say
  // so, by policy iteration with sparse linear solves [BT91, Prop. 2], the upper bound proved as before. nullopt:
  // stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<Solution> solve(const IterationOptions& limits);

  // The backend of optimistic_iteration.hpp.
  std::uint64_t sweeps() const { return x_.sweeps; }
  bool refine(double change, const IterationOptions& options);
  void guess(double tolerance);
  bool prove(std::uint64_t sweeps, const IterationOptions& options);

 private:
  enum Side : std::uint8_t { Below, Above };
  static constexpr std::uint64_t most_tries = 64;  // sweeps for a proof, besides as many as went before
  std::uint32_t rows() const { return static_cast<std::uint32_t>(first_choice_.size()) - 1; }
  std::uint32_t choices() const { return static_cast<std::uint32_t>(constant_[Below].size()); }
  bool better(double a, double b) const { return measure_ == Measure::MaxProbability ? a > b : a < b; }
  double value(std::uint32_t choice, const std::vector<double>& x, Side side) const;
  double best(std::uint32_t row, const std::vector<double>& x, Side side) const;
  void start_from_best_luck();
  void make_chunks(std::size_t threads);
  std::uint32_t chunk_end(std::size_t chunk) const {
    return std::min(rows(), static_cast<std::uint32_t>(chunk + 1) * chunk_size_);
  }
  double raise(std::size_t chunk);
  bool close_from_above(std::size_t chunk);
  bool close_in_sweeps(std::uint64_t most, std::size_t threads);
  bool raise_to_bounds(const IterationOptions& limits);
  double width_of_known() const;

  struct Sources {  // by unknown: the choices that it is an outcome of
    std::vector<std::uint32_t> first, choice, row_of;
  };
  Sources sources() const;
  using Policy = std::vector<std::uint32_t>;  // by row, a choice
  Policy progress() const;                    // every row gets somewhere
  Policy greedy() const;
  bool evaluate(const Policy& policy, std::vector<double>& x);
  bool iterate_policies(const IterationOptions& limits);
  bool lowers_nothing(const std::vector<double>& x) const;

  Measure measure_;
  std::vector<std::uint32_t> first_choice_, first_term_, unknown_;
  std::vector<double> coefficient_, constant_[2], cost_, least_known_;  // the last two for costs only
  Solution x_;
  bool linear_ = false;           // policies may be tried
  std::uint64_t patience_ = 0;    // sweeps before they are
  double steps_ = 0;              // that a run of the last policy takes, expected, from its slowest row
  bool by_policies_ = false;      // that is where the values come from
  std::uint32_t chunk_size_ = 0;  // rows, but for the last chunk
  ChunkReach reach_{0};           // of chunks
};

}  // namespace waymark::plan
