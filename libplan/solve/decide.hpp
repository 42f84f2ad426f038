// The two questions asked of a product: the greatest probability with which a strategy satisfies the task, and the
// least expected cost until it has. Answers carry proved bounds, the strategy, and what the strategy is worth when it
// is evaluated as a Markov chain of its own; costs only the bounds where no strategy is asked for and rounding is safe.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libplan/model/grid_world.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/optimistic_iteration.hpp"
#include "libplan/solve/strategy.hpp"

namespace waymark::plan {

struct Bounds {                                                                           // bounds of a value
  double lower = 0, upper = 0;                                                            // proved
  double middle() const { return lower == upper ? lower : lower + (upper - lower) / 2; }  // of the bounds
};

struct Decided {             // the answer
  Bounds value;              // of the start
  Strategy strategy;         // attains the value up to the tolerance, or else is the best that was found
  Bounds re_evaluated;       // of the strategy, by the Markov chain that it makes of the product; without: the value
  std::uint64_t sweeps = 0;  // of value iteration
  // With keep_values, by state what a choice attains; of costs, 0 where no cost is finite.
  std::vector<double> values = {};
  double tolerance = 0;  // of the bounds: coarser than what was asked for where doubles end
  bool attained = true;  // does the strategy attain the value? Doubles may be too coarse to find one that does
};

// Is Pmax above 0, and is it 1? By the graph alone.
enum class Qualitative : std::uint8_t { None, Some, Sure };
template <class Model>
Qualitative qualitative(const ProductMdp<Model>& product);

// Pmax: the greatest probability of reaching a goal (finite tasks) or of meeting marked edges for ever (infinite ones;
// that this is the probability of the formula is what MdpSafe stands for). [BK08, Thm. 10.56]
// nullopt: stopped, or bounds that doubles cannot bring together at all.
// Pmin is 1 − Pmax of the opposite: of the negation, or of a finite task by TaskTable::never.
template <class Model>
std::optional<Decided> greatest_probability(const ProductMdp<Model>& product, const IterationOptions& limits = {});

// Least expected cost until a goal is reached; infinite (lower = upper = ∞) unless some strategy reaches one almost
// surely.
template <class Model>
std::optional<Decided> least_cost(const ProductMdp<Model>& product, const IterationOptions& limits = {});

}  // namespace waymark::plan
