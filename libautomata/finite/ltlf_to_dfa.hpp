// LTLf → minimal DFA: a formula is closed under progression symbolically, and the result is minimised. Past operators
// become propositions, which the DFA then forgets (without_past.hpp, projection.hpp).
#pragma once
#include <cstddef>
#include <stop_token>
#include <variant>

#include "libautomata/finite/dfa.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

using ltl::Exhausted;  // in place of an automaton

// The minimal complete state-based DFA whose initial state rejects the empty word; canonical numbering
// (breadth first from the initial state, letters in BDD order): same formula, same bytes.
//
// Without limits but one: a formula with more than Mtbdd::max_variables propositions, or temporal subformulas and
// propositions that no decomposition brings down, is too large for a diagram: std::length_error here, Exhausted below.
Dfa ltlf_to_dfa(ltl::Formula f);
std::variant<Dfa, Exhausted> ltlf_to_dfa(ltl::Formula f, const ltl::Limits& limits);

}  // namespace waymark::automata
