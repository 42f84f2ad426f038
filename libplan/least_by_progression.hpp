// A referee of planners: the least number of actions by which a finite word of the map satisfies a formula, found
// without any automaton. A pair is a pose and what remains of the formula after the letters so far (progress.hpp); the
// search is breadth first over them. It shares nothing with the translation, the product and the search of the planner.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>

#include "libltl/formula.hpp"
#include "libltl/limits.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

struct LeastActions {                  // to satisfy a formula
  std::optional<std::size_t> actions;  // nothing: proved that no word of the map satisfies the formula
  std::size_t pairs = 0;               // that were met
};

// nullopt: more pairs than the limit were met, a formula grew with the word beyond all bounds, or stopped. What remains
// is simplified after every letter. Throws ltl::FormatError for a proposition that the map lacks. O(pairs ·
// |formulas|).
std::optional<LeastActions> least_by_progression(ltl::Formula formula, const Map& map, std::span<const PoseId> starts,
                                                 const ltl::Limits& limits = {});

}  // namespace waymark::plan
