// Any automaton on infinite words to a deterministic parity automaton of the same language.
//
// The states of a deterministic automaton are copied as often as its acceptance condition requires [CCF21]. A
// nondeterministic automaton is first translated to a generalised Büchi automaton, then reduced and determinised.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/deterministic/parity.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libautomata/omega/operations.hpp"

namespace waymark::automata {

// The result is reduced and its states are numbered canonically. The function throws what the budget throws.
Dpa to_parity(const Automaton& automaton, Budget& budget);

// The automaton itself where it is deterministic, else to_parity() of it.
Deterministic determinized(const Automaton& automaton, Budget& budget);

}  // namespace waymark::automata
