// What an answer of `translate --format json` claims: its automaton against the definition of ⊨, word by word, and the
// numbers beside it against the automaton.
#pragma once
#include <cstddef>
#include <stop_token>
#include <string>

#include "tools/claims.hpp"

namespace waymark::tools {

// On so many words: the shortest ones over all letters as far as half of them go, then random ones. Throws
// ltl::FormatError for an answer that is none, ltl::SyntaxError for its formula.
void examine_automaton(Claims& claims, const plan::JsonReader& in, const std::string& source, std::size_t words,
                       const std::stop_token& stop);

}  // namespace waymark::tools
