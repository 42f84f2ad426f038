// The properties of a JANI document [BDH+17] as questions of the same kind as those of PRISM.
#pragma once
#include <vector>

#include "libplan/model/formats/prism_properties.hpp"

namespace waymark::plan {

// Pmin, Pmax, Emin and Emax in the initial state, alone, in a filter, or compared with a number. The text of a property
// is its name. Anything else is a property with a fault. Throws as parse_jani.
std::vector<PrismProperty> parse_jani_properties(const PrismSource& document, const PrismConstants& constants = {},
                                                 const ltl::Limits& limits = {.states = most_model_states});

}  // namespace waymark::plan
