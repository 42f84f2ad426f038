// Models for tools that read JANI, version 1 [BDH+17]: Storm, the Modest Toolset, and others.
//
// One automaton of type mdp with a location for each state. Propositions are transient Boolean variables, true in the
// locations where they hold; the transient variable `cost` is assigned on the edges. Where a proposition `goal` (or
// `marked`) tells acceptance, as in products, properties ask for the probability and the least cost of the task.
#pragma once
#include <string>
#include <string_view>

#include "libplan/model/prism/state_labels.hpp"

namespace waymark::plan {

// Names are kept; a proposition called `cost` gets an underscore. Ends with a line break. O(outcomes).
std::string write_jani(const StateLabelled& model, std::string_view name);

}  // namespace waymark::plan
