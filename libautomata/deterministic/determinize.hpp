// Büchi to deterministic parity automata, by ordered trees of states.
//
// A macro-state maps each state of some run to a brace, a node of an ordered tree whose nodes are numbered by age. An
// accepting branch moves its run into a fresh brace inside its own brace. A state that is reached in several ways stays
// in the oldest, then deepest brace. A brace all of whose runs have moved further in is accepting, and its inner braces
// are removed. A brace without runs is removed, and younger ones move up. The oldest brace to which either happens
// gives the colour. This is [Saf88] in the form of [Pit07] and [Red12], with marks on edges as in [SV12]. Runs in
// rejecting components carry no brace; a run that enters an accepting component starts a brace there. Ours: each entry
// of a deterministic component starts a brace, so such a component is not determinised again. A state is removed when
// another one simulates it in a later component, or in the same component in a brace that is no worse.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// Generalised Büchi to Büchi, marks on edges: levels as in degeneralize(), acceptance on the branch that ends a round.
// Deterministic in, deterministic out. One state of budget per copy.
TransitionRelation degeneralize_on_edges(const TransitionRelation& automaton, Budget& budget);

// Generalised Büchi in, deterministic out: parity(Min, Even, ·), at most one mark on a branch, none being the worst.
// Not complete: where no run goes on there is no branch. One state of budget per macro-state; more colours than
// Marks::most count as too many.
TransitionRelation determinize(const TransitionRelation& automaton, Budget& budget);

}  // namespace waymark::automata
