// Minimisation of symbolic DFAs: one state for each class of the coarsest partition that acceptance and letters
// respect.
//
// Very weak automata (every cycle is a self-loop, as for most planning goals) are minimised in one bottom-up pass
// (very_weak.hpp), all others by partition refinement (refinement.hpp).
#pragma once
#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"

namespace waymark::automata {

// The quotient, its states in no particular order (canonical() numbers them); unreachable states count as any other.
// Throws what the budget throws.
Transitions minimize(const Transitions& automaton, Budget& budget);

// The minimal automaton of the same language, canonically numbered, reading only what it depends on.
Dfa minimize(const Dfa& dfa, Budget& budget);
inline Dfa minimize(const Dfa& dfa) {
  Budget unlimited;
  return minimize(dfa, unlimited);
}

// Drops the propositions that no edge asks for. reads[v]: the proposition of variable v.
Dfa as_dfa(Transitions automaton, const ltl::Vocabulary& vocabulary, const std::vector<ltl::Proposition>& reads);

}  // namespace waymark::automata
