// Certificates of translations: the automaton of φ against that of ¬φ, and against the definition.
//
// On finite words both are DFAs: that they accept no word together, and every word one of them, is decided. On infinite
// words too, nondeterministic automata being determinised for the second question; where that takes too much the
// question is tried on words, the definition of ⊨ being the referee.
#pragma once
#include <cstddef>

#include "libltl/limits.hpp"
#include "tools/translations.hpp"

namespace waymark::tools {

struct Certificate {
  bool proved = false;    // else: disjointness only, and some words
  std::size_t words = 0;  // that were tried
};

// Throws std::logic_error, with the formula and a word, when the automaton is wrong, and automata::Budget::Exceeded
// when the stop comes first. Of a result that is an automaton.
Certificate certify(ltl::Formula formula, const Translated& result, const Translation& translation,
                    const ltl::Limits& limits);

}  // namespace waymark::tools
