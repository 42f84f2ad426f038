// The greatest discounted reward of a finite task: E γ^(T−1), T the number of actions until the task is satisfied for
// the first time, 0 when it never is; 1 where it is at the start. What learners maximise (libplan/learn), on any model.
//
// Sweeps from below in place (discounted_sweeps.hpp). A strategy that is greedy for values within ε loses at most
// 2 ε γ / (1 − γ) [SB18, Sec. 4.2], so the sweeps go on until that is below the tolerance; the strategy is evaluated as
// a Markov chain by the same sweeps.
#pragma once
#include <optional>

#include "libplan/solve/decide.hpp"

namespace waymark::plan {

// `tolerance` is absolute. nullopt: stopped. Throws std::invalid_argument unless 0 < discount < 1.
template <class Model>
std::optional<Decided> greatest_discounted(const ProductMdp<Model>& product, double discount,
                                           const IterationOptions& limits = {});

}  // namespace waymark::plan
