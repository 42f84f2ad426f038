// The greatest expected cost until the task is done: what the worst strategy pays.
#pragma once
#include <optional>

#include "libplan/solve/decide.hpp"

namespace waymark::plan {

// Infinite (lower = upper = ∞) when some strategy has a chance never to reach a goal. Otherwise the product has no end
// component without goals, the Bellman operator has one fixpoint, and values that it does not raise are upper bounds
// [HK20, Thm. 3]. nullopt: stopped, out of sweeps, or bounds that doubles cannot bring together.
//
// Sweeps over a written-out product, 12 bytes an outcome and 16 a choice: O(edges) each.
template <class Model>
std::optional<Bounds> greatest_cost(const ProductMdp<Model>& product, const IterationOptions& limits = {});

}  // namespace waymark::plan
