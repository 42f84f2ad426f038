// A referee of values on models: bounds that grow, by progression and Bellman's equations, without an automaton and
// without end components. A pair is a state of the model and what remains of the formula.
//
// From 0 on, sweeps raise the probability (or cost) until what remains is `true`. Each sweep gives a bound from below
// of the probability that a prefix decides the formula for good, which is no greater than that of the formula, and of
// the least expected cost until then [BK08, Thm. 10.100].
#pragma once
#include <cstdint>
#include <optional>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libplan/model/formats/read_case.hpp"

namespace waymark::tools {

enum class FromBelow : std::uint8_t { GreatestProbability, LeastProbability, LeastCost };

// A bound from below that reaches `enough`, or the best one that was found. Nothing: more pairs than the limit, or
// stopped before the first bound.
std::optional<double> value_from_below(const plan::PlanningCase& model, ltl::Formula formula, FromBelow what,
                                       double enough, const ltl::Limits& limits);

}  // namespace waymark::tools
