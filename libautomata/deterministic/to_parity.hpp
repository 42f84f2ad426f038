// Any automaton on infinite words to a deterministic parity automaton of the same language.
//
// A deterministic one keeps its states but for copies that its condition needs [CCF21]; a nondeterministic one becomes
// generalised Büchi, is reduced and determinised.
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
