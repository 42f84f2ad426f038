// Projection: an automaton that forgets propositions accepts a word when some choice of them was accepted.
//
// The last propositions in the order of the diagram are forgotten: their levels of each diagram collapse into the union
// of the choices below. The result is exact for every acceptance condition; determinism may be lost.
#pragma once
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

// Forgets the propositions that `names`, a beginning of the vocabulary, lacks. O(diagram · branches).
Automaton projected(const Automaton& automaton, const ltl::Vocabulary& names);

}  // namespace waymark::automata
