// The kinds of automata that a formula is translated to, made of any automaton on infinite words instead.
//
// Each keeps the language. Nondeterministic automata are determinised where the kind asks for it [to_parity.hpp]; a
// limit-deterministic automaton is made of the parity automaton.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

// The functions throw what the budget throws.
Automaton to_tgba(const Automaton& automaton, Budget& budget);   // generalised Büchi, marks on edges, reduced
Automaton to_rabin(const Automaton& automaton, Budget& budget);  // deterministic, with the pairs of a parity condition
Automaton to_generic(const Automaton& automaton, Budget& budget);  // deterministic: its own condition, or a parity one

}  // namespace waymark::automata
