// Street maps as Markov decision processes (docs/formats/planning-cases.md).
//
// A state is a landmark, its letter the landmark's name in snake_case ("Ashley's" is ashleys); a choice is a way,
// called after where it leads, its cost are metres. Nothing slips.
#pragma once
#include <string_view>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

// Landmarks keep the order of the file, choices follow the order of the ways. `start`: an id or a name in snake_case;
// empty: the first landmark. Throws ltl::FormatError with line and column.
Mdp parse_streets(std::string_view json, std::string_view source = "", std::string_view start = "");

}  // namespace waymark::plan
