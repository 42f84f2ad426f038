// Transition systems in YAML, as the ROS package ltl_automaton_core of KTH reads them (docs/formats/models.md).
//
// A system is the product of its state models, one of which moves at a time. A move is an action with a weight, its
// cost, and a guard over the names of the nodes that hold before the move. The propositions are the names of the nodes;
// the letter of a move has those of the state behind it.
#pragma once
#include <string_view>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// Throws ltl::FormatError with line and column. The reachable part of the product, at most 1,000,000 states and
// 16 MiB of text.
Mdp parse_transition_system(std::string_view yaml, std::string_view source);

}  // namespace waymark::plan
