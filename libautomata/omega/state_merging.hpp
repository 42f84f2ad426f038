// Language-preserving state merging: states of different languages become one where the automaton keeps its language.
//
// Merging two states can only add words. Whether a merge adds words is decided by emptiness of the product with an
// automaton of the complement. The product over all pairs of states is built once, and merging states merges its
// vertices. Most pairs are refuted by a pair of words: u leads to q, r accepts v, and uv is outside the language. The
// other pairs are tried in turn. Merging needs neither simulation nor equal languages: for F G a ∨ G F b, a state that
// waits for the right moment absorbs the component that the moment leads to. SAT solvers find the smallest
// deterministic automata under the same condition, that the whole language stays [BDL14]; they search for a new
// automaton, and ours only merges states.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/reduce.hpp"

namespace waymark::automata {

// `automaton` and `outside` are generalised Büchi and accept complementary languages, over the same variables. States
// are merged and what comes out is reduced, until nothing changes; nothing is done where the product would be too
// large. With marks on states those with and without are not mixed. Never throws Budget::Exceeded except when stopped.
Reduced state_merged(TransitionRelation automaton, const TransitionRelation& outside, MarksOn marks, Budget& budget);

}  // namespace waymark::automata
