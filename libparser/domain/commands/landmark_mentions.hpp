// Which words of a command name which landmark of a city: by names, parts and misspellings of names, and by tags.
//
// A phrase is worth what its words tell: a word that fits few landmarks of the map tells more (inverse frequency). The best
// set of phrases that do not overlap is found by dynamic programming over the tokens.
#pragma once
#include <string>
#include <vector>

#include "libparser/domain/commands/command_domain.hpp"

namespace waymark::parser {

std::vector<CommandDomain::Lift> lift_landmarks(const std::string& text,
                                                const std::vector<Landmark>& landmarks);

}  // namespace waymark::parser
