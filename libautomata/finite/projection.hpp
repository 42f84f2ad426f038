// Projection: a DFA that forgets propositions accepts a word when some choice of them was accepted.
//
// The last propositions in the order of the diagram are forgotten, so quantification collapses the lower levels of each
// diagram into sets of states; the subset construction follows. States from which nothing is accepted are in no set, so
// a DFA in which the letters read determine what is forgotten keeps its size.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"

namespace waymark::automata {

// Forgets the propositions that `names`, a beginning of the vocabulary, lacks. Minimal. Throws what the budget throws:
// a state for every set.
Dfa projected(const Dfa& dfa, const ltl::Vocabulary& names, Budget& budget);

}  // namespace waymark::automata
