// States folded into others that accept other words, as long as the automaton accepts the same.
//
// Two states made one accept whatever either did, and runs may cross from one to the other, so the language can only
// grow. Whether it does is a question to an automaton of the words outside: their product, over all pairs of states,
// is made once, and making states one makes vertices of it one. Most pairs of states are refused at a glance: with
// some word u may q be reached, from r be left by some v, and uv lies outside. The others are tried, one after the
// other. No simulation is asked for: a state that waits for the right moment takes in the component that the moment
// leads to (F G a ∨ G F b). Nor need their languages be equal. That only the whole language need
// stay is how SAT solvers find the smallest deterministic automata [BDL14]; they start afresh, ours only merges.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/reduce.hpp"

namespace waymark::automata {

// `automaton` and `outside` are generalised Büchi and accept complementary languages, over the same variables. States
// are folded and what comes out is reduced, until nothing changes; nothing is done where the product would be too
// large. With marks on states those with and without are not mixed. Never throws Budget::Exceeded except when stopped.
Reduced folded(TransitionRelation automaton, const TransitionRelation& outside, MarksOn marks,
               Budget& budget);

}  // namespace waymark::automata
