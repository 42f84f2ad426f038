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
  std::stop_token stop = {};
};

// Does a sweep that turns `before` into `after` raise it, by more than the rounding of a sum?
inline bool raises(double before, double after) { return after > before * (1 + 1e-15); }

class Equations {
 public:
  explicit Equations(Measure measure) : measure_(measure) {}

  // Row after row, choice after choice, in the order in which they are to be swept.
  void add_row() { first_choice_.push_back(choices()); }
  void add_choice() { first_term_.push_back(static_cast<std::uint32_t>(unknown_.size())); }
  void add_term(std::uint32_t unknown, double coefficient) {
    unknown_.push_back(unknown);
    coefficient_.push_back(coefficient);
  }
  void end_choice(double constant_below, double constant_above) {
    constant_[0].push_back(constant_below);
    constant_[1].push_back(constant_above);
  }

  struct Solution {
    std::vector<double> lower, upper;  // by row
    std::uint64_t sweeps = 0;
  };
  // Optimistic value iteration [HK20, Alg. 2]; greatest probabilities that are slow to settle, and everything when
  // limits.linear_solves say so, by policy iteration with sparse LU factors [BT91, Prop. 2], the upper bound proved as
  // before. nullopt: stopped, out of sweeps, or the bounds do not meet in doubles.
  std::optional<Solution> solve(const IterationLimits& limits);

 private:
  enum Side : std::uint8_t { Below, Above };
  std::uint32_t rows() const { return static_cast<std::uint32_t>(first_choice_.size()) - 1; }
  std::uint32_t choices() const { return static_cast<std::uint32_t>(first_term_.size()); }
  bool better(double a, double b) const { return measure_ == Measure::MaxProbability ? a > b : a < b; }
  double value(std::uint32_t choice, const std::vector<double>& x, Side side) const;
  double best(std::uint32_t row, const std::vector<double>& x, Side side) const;
  double raise();
  bool close_from_above();
  void guess_above(double tolerance);
  bool prove(double tolerance, std::uint64_t sweeps);

  std::vector<std::uint32_t> progress() const;  // a policy under which every row gets somewhere
  std::vector<std::uint32_t> greedy() const;
  bool evaluate(const std::vector<std::uint32_t>& policy, std::vector<double>& x) const;
  bool iterate_policies(const IterationLimits& limits);

  Measure measure_;
  std::vector<std::uint32_t> first_choice_, first_term_, unknown_;
  std::vector<double> coefficient_, constant_[2];
  Solution x_;
};

}  // namespace waymark::plan
