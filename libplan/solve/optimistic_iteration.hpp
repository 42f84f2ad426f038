// The driver of optimistic value iteration [HK20, Alg. 2]: refine, guess, prove; where the proof fails, refine further.
//
// A backend holds the values of one block. It refines them until they hardly change, guesses bounds on both sides of
// them, and proves the guess by sweeps: u with Φ(u) ≤ u lies above the least fixpoint of Φ, which is the value. Three
// backends: Equations (written out), GridBlock (a window of a grid), SweptBlock (anything else, state by state).
#pragma once
#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <stop_token>

namespace waymark::plan {

enum class Measure : std::uint8_t { MaxProbability, MinCost };                                 // what is optimised
constexpr bool is_probability(Measure measure) { return measure == Measure::MaxProbability; }  // else a cost

struct Sweepers {           // threads that may sweep
  std::size_t threads = 1;  // at most
  // How many of them are at work, the one that asks among them; the others may help it.
  const std::atomic<std::size_t>* working = nullptr;
  std::size_t free() const {
    const std::size_t others = working != nullptr ? std::max<std::size_t>(*working, 1) - 1 : 0;
    return threads > others ? threads - others : 1;
  }
};

struct IterationOptions {             // what is proved, and at which price
  double tolerance = 1e-6;            // upper − lower, proved: absolute for probabilities, relative for costs
  bool policy_iteration = false;      // linear solves from the start, not only where sweeps are slow
  std::uint64_t sweeps = UINT64_MAX;  // of each block
  std::size_t written_out = std::size_t{1} << 20U;  // unknowns of a block up to which its equations are written out
  std::size_t on_grid = 2'000;  // unknowns of a block of a grid from which it is swept in place, where its kind allows
  bool second_way = true;       // blocks of grids that sweeps do not solve are written out then, if they are small
  bool keep_values = false;     // of all states, in the answer
  bool strategy = true;         // in the answer; costs may be proved without one
  Sweepers sweepers = {};       // of no influence on any number
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();  // for the arrays of values of large grids
  std::stop_token stop = {};                                             // polled between sweeps
};

// Does a sweep that turns `before` into `after` raise it, by more than the rounding of a sum? What is no number does.
inline bool raises(double before, double after) { return !(after <= before * (1 + 1e-15)); }

template <class B>
concept OptimisticBackend = requires(B& backend, double number, std::uint64_t sweeps, const IterationOptions& options) {
  { backend.sweeps() } -> std::same_as<std::uint64_t>;        // so far
  { backend.refine(number, options) } -> std::same_as<bool>;  // until a sweep changes less; false: out of limits
  backend.guess(number);                                      // bounds, so far apart
  { backend.prove(sweeps, options) } -> std::same_as<bool>;   // after so many sweeps of refinement
};

enum class IterationEnd : std::uint8_t { Proved, NotProved, OutOfLimits };  // of a block

// change: what a sweep may still change at the first guess. NotProved: the bounds do not meet in doubles.
template <OptimisticBackend Backend>
IterationEnd iterate_optimistically(Backend& backend, const IterationOptions& options, double change) {
  for (;; change = change < 1e-24 ? 0 : change / 64) {
    const std::uint64_t before = backend.sweeps();
    if (!backend.refine(change, options)) return IterationEnd::OutOfLimits;
    backend.guess(options.tolerance);
    if (backend.prove(backend.sweeps() - before, options)) return IterationEnd::Proved;
    if (options.stop.stop_requested()) return IterationEnd::OutOfLimits;
    if (change == 0) return IterationEnd::NotProved;
  }
}

}  // namespace waymark::plan
