// Models in JANI, version 1, of type mdp or dtmc [BDH+17], as far as docs/formats/prism.md says.
//
// Transient truth values of the document become propositions. Costs are a transient number of the document: what the
// locations say of it in the state that is left, and what the edges assign to it. It is the one called "cost" or
// "steps", else the first; 1 a choice when there is none. A state in which no edge is enabled gets a choice that stays.
#pragma once
#include <string_view>

#include "libltl/limits.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/model/prism/read_prism.hpp"

namespace waymark::plan {

// States are numbered breadth first, in the order of elements, edges, synchronisations and destinations. Throws
// ltl::FormatError with the place, also for what JANI has and this reader has not, and for more states than the limit;
// ReadingStopped.
Mdp parse_jani(std::string_view text, std::string_view source = "",
               const ltl::Limits& limits = {.states = most_model_states}, const PrismOptions& options = {});

}  // namespace waymark::plan
