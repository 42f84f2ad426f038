// How sweeps of a grid begin: the step of a guess of costs, and by how much the steps of sweeps are lengthened.
#pragma once
#include <algorithm>

namespace waymark::plan {

// What a move that costs so much is taken to cost on the way, when it goes forward and back with these chances: what it
// gets on by against its slips, and a little more. Where a guess is too small, a front leads cells astray until it has
// passed, and values rise by a move a sweep; one that is too great only costs a sweep more.
inline double guessed_step(double cost, double forward, double back) {
  constexpr double a_little_more = 1.05, least_progress = 0.25;
  return a_little_more * cost / std::max(forward - back, least_progress);
}

// Where moves are likely to slip. Where they are not, cells follow each other in long chains, along which a factor too
// great would grow. `likely`: the chance that a move goes where it should.
inline double over_relaxation_of(double likely) { return std::clamp(0.85 / likely, 1.0, 1.1); }

// A change of a cost counts relative to the value, or to so many moves where the value is more: bounds a share of the
// value apart are inductive where what is left to change is that share of a move.
inline constexpr double moves_of_a_change = 512;

}  // namespace waymark::plan
