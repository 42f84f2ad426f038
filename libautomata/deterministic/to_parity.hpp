// Any automaton on infinite words to a deterministic parity automaton of the same language.
//
// A deterministic automaton keeps its states up to the copies that its condition needs [CCF21]. A nondeterministic one
// is made generalised Büchi, reduced and determinised.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/deterministic/parity.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libautomata/omega/operations.hpp"

namespace waymark::automata {

// Reduced, in canonical numbering. Throws what the budget throws.
Dpa to_parity(const Automaton& automaton, Budget& budget);

// The automaton itself where it is deterministic, else to_parity() of it.
Deterministic determinized(const Automaton& automaton, Budget& budget);

}  // namespace waymark::automata
