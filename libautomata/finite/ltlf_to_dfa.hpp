// LTLf → minimal DFA: a formula is closed under progression symbolically, and the result is minimised. Past operators
// become propositions, which the DFA then forgets (without_past.hpp, projection.hpp).
#pragma once
#include <cstddef>
#include <stop_token>
#include <variant>

#include "libautomata/finite/dfa.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

struct TranslationLimits {         // when a construction gives up
  std::size_t states = 1'000'000;  // states before minimisation, those of intermediate steps included
  std::stop_token stop = {};       // polled at least every few milliseconds
};

struct Exhausted {         // nothing proved: a limit was met or a stop was requested
  std::size_t states = 0;  // made so far
};

// The minimal complete state-based DFA whose initial state rejects the empty word; canonical numbering
// (breadth first from the initial state, letters in BDD order): same formula, same bytes.
//
// Without limits but one: a formula with more than Mtbdd::max_variables propositions, or temporal subformulas and
// propositions that no decomposition brings down, is too large for a diagram: std::length_error here, Exhausted below.
Dfa ltlf_to_dfa(ltl::Formula f);
std::variant<Dfa, Exhausted> ltlf_to_dfa(ltl::Formula f, const TranslationLimits& limits);

}  // namespace waymark::automata
