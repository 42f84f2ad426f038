// The optimality equations of the unknowns of one block, written out, and two ways to solve them between bounds.
//
//   x_i = best over the choices c of i of  constant(c) + Σ coefficient(t) · x_unknown(t)
//
// What is known already is in the constants, of which there are two, for the lower and for the upper bound. A choice
// that may come to nothing is taken until it comes to something: its row is divided by the chance that it does.
// Twelve bytes a term; blocks of many unknowns are better swept without being written out (value_iteration.hpp).
#pragma once
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace waymark::plan {

enum class Measure : std::uint8_t { MaxProbability, MinProbability, MinCost };
constexpr bool is_probability(Measure measure) { return measure != Measure::MinCost; }

struct IterationLimits {
  double tolerance = 1e-6;            // upper − lower: absolute for probabilities, relative for costs
  std::uint64_t sweeps = UINT64_MAX;  // of each block
  bool linear_solves = false;         // policy iteration from the start, not only where sweeps are slow
  std::size_t written_out = std::size_t{1} << 20U;  // unknowns of a block up to which its equations are
  std::size_t on_grid =
      20'000;  // unknowns of a block of a grid from which it is swept in place (grid_block.hpp)
  std::stop_token stop = {};
};

// Does a sweep that turns `before` into `after` raise it, by more than the rounding of a sum?
inline bool raises(double before, double after) { return after > before * (1 + 1e-15); }

class Equations {
 public:
  static constexpr std::uint32_t factored = 20'000;  // rows up to which LU factors are made
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
    double below = 0, above = 0, cost = 0, least_known = 0;
  };
  void end_choice(const Constants& constants) {
    constant_[0].push_back(constants.below);
    constant_[1].push_back(constants.above);
    if (measure_ != Measure::MinCost) return;
    cost_.push_back(constants.cost);
    least_known_.push_back(constants.least_known);
  }

  struct Solution {
    std::vector<double> lower, upper;  // by row
    std::uint64_t sweeps = 0;
  };
  // Optimistic value iteration [HK20, Alg. 2]; what is slow to settle, and everything when limits.linear_solves say so,
  // by policy iteration with sparse linear solves [BT91, Prop. 2], the upper bound proved as before. nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<Solution> solve(const IterationLimits& limits);

 private:
  enum Side : std::uint8_t { Below, Above };
  static constexpr std::uint64_t most_tries = 64;  // sweeps for a proof, besides as many as went before
  std::uint32_t rows() const { return static_cast<std::uint32_t>(first_choice_.size()) - 1; }
  std::uint32_t choices() const { return static_cast<std::uint32_t>(constant_[Below].size()); }
  bool better(double a, double b) const { return measure_ == Measure::MaxProbability ? a > b : a < b; }
  double value(std::uint32_t choice, const std::vector<double>& x, Side side) const;
  double best(std::uint32_t row, const std::vector<double>& x, Side side) const;
  void start_from_best_luck();
  double raise();
  bool close_from_above();
  void guess_above(double tolerance);
  bool prove(double tolerance, std::uint64_t sweeps);

  struct Sources {  // by unknown: the choices that it is an outcome of
    std::vector<std::uint32_t> first, choice, row_of;
  };
  Sources sources() const;
  std::vector<std::uint32_t> progress() const;  // a policy under which every row gets somewhere
  std::vector<std::uint32_t> greedy() const;
  bool evaluate(const std::vector<std::uint32_t>& policy, std::vector<double>& x) const;
  bool iterate_policies(const IterationLimits& limits);
  bool lowers_nothing(const std::vector<double>& x) const;

  Measure measure_;
  std::vector<std::uint32_t> first_choice_, first_term_, unknown_;
  std::vector<double> coefficient_, constant_[2], cost_, least_known_;  // the last two for costs only
  Solution x_;
};

}  // namespace waymark::plan
