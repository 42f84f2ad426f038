// Values of a task between proved bounds, found by all ranks together: every rank sweeps its band, and bands exchange
// border rows.
//
// Components of the automaton are solved one after the other, those first that others lead to. Probabilities and
// discounted rewards rise from 0 by sweeps, whatever the age of the halo, so that they are lower bounds at all times.
// Costs are swept from a guess. Bounds are then guessed beside what was found, and proved: u with Φ(u) ≤ u lies above
// the least fixpoint of Φ, which is the value [HK20]; costs l with l ≤ Φ(l) lie below it, since the best strategy
// arrives almost surely and every move costs. A guess of u is proved when, between two exchanges, no rank has raised it
// anywhere: the halos are then no less than what their owners have. Of l the same holds with the order turned round.
// Until then the bounds are what sweeps from below have reached, or 0, and 1, or infinite. Rounding is counted as in
// libplan/solve/optimistic_iteration.hpp.
#pragma once
#include <petscvec.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>

#include "libplan/solve/decide.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
#include "tools/distributed/band_block.hpp"
#include "tools/distributed/kept_bands.hpp"

namespace waymark::tools {

struct SharedOptions {
  double tolerance = 1e-6;         // upper − lower: absolute, of costs relative
  double discount = 1;             // of discounted rewards
  std::uint32_t local_sweeps = 2;  // of a band between two exchanges, at most
  double checkpoint_seconds = 30;  // between two checkpoints
  std::stop_token stop = {};       // of this rank; all ranks stop then
};

struct SharedStatistics {  // of this rank
  std::uint64_t pairs = 0, unknowns = 0;
  std::uint64_t rounds = 0;   // exchanges while sweeping; the same of all ranks
  std::uint64_t updates = 0;  // of unknowns
  std::uint64_t longest = 0;  // in each round those of the rank with the most; the same of all ranks
  std::uint64_t values = 0;   // that it was sent
  double sweeping = 0;        // seconds
  double exchanging = 0;      // seconds in exchanges, waiting for neighbours included
  double agreeing = 0;        // seconds in reductions over all ranks, waiting included
  std::uint64_t resumed = 0;  // components whose bounds were kept
  std::uint64_t checkpoints = 0;
};

class BandValues {
 public:
  // `kept` may be absent; all else must outlive the object. Collective, as all that is not const.
  BandValues(const Ranks& ranks, const BandProduct& product, const BandSets& sets, SharedMeasure measure,
             const SharedOptions& options, const KeptBands* kept);
  ~BandValues();
  BandValues(const BandValues&) = delete;
  BandValues& operator=(const BandValues&) = delete;

  bool solve();                                    // false: stopped, or doubles end before the bounds meet
  plan::Bounds value() const;                      // of the start, whether or not it is solved. Collective.
  double tolerance() const { return tolerance_; }  // that was proved
  bool stopped() const { return stopped_; }        // some rank was asked to
  const SharedStatistics& statistics() const { return statistics_; }

  // The backend of optimistic_iteration.hpp, of the current component.
  std::uint64_t sweeps() const { return statistics_.rounds; }
  bool refine(double change, const plan::IterationOptions& options);
  void guess(double tolerance);
  bool prove(std::uint64_t sweeps, const plan::IterationOptions& options);

 private:
  struct Component {
    std::uint32_t first, last;  // automaton states
  };
  using Clock = std::chrono::steady_clock;
  struct Told {
    double change;
    bool failed, stop;
  };
  bool is_cost() const { return measure_ == SharedMeasure::MinCost; }
  void fetch(double* values);
  void end_component();
  bool find_kept();
  void keep_values();
  std::span<double> own(double* values, std::uint32_t state) const;
  bool solve_component(std::size_t among);
  SweepResult sweep(double* values, SweepKind kind, double least);
  Told agree(const SweepResult& own);
  bool start_costs();
  bool start_front();
  bool find_ways(double* ways);
  bool refine(double* values, SweepKind kind, double change);
  plan::Bounds bounds(std::uint32_t pair) const;

  const Ranks* ranks_;
  const BandProduct* product_;
  const BandSets* sets_;
  SharedMeasure measure_;
  SharedOptions options_;
  const KeptBands* kept_;
  Vec lower_vector_ = nullptr, upper_vector_ = nullptr;  // of this rank: all pairs, and a 0 for the trap
  double *lower_ = nullptr, *upper_ = nullptr;           // their values
  Component component_{0, 0};
  std::unique_ptr<Halo> halo_;        // of the planes of the component
  std::unique_ptr<BandBlock> block_;  // of the component
  double tolerance_;                  // of all components
  double share_ = 0, own_share_ = 0;  // of components up to this one; of this one
  double front_ = 0, deepest_ = 0;    // up to which least way sweeps go; the greatest there is
  std::uint32_t proved_ = 0;          // states below are proved
  bool stopped_ = false;
  Clock::time_point kept_at_ = Clock::now();
  SharedStatistics statistics_;
};

}  // namespace waymark::tools
