// Büchi to deterministic parity: trees of braces, the states that a run may be in nested by how they came to accept.
//
// A macro-state maps each state that some run is in to a brace, a node of an ordered tree whose nodes are numbered by
// age. An accepting branch moves its run into a fresh brace inside its own; a state reached in several ways stays in
// the oldest, then deepest brace. A brace all of whose runs have moved further in is accepting: the inner ones go. A
// brace that lost all runs goes, and younger ones move up. The oldest brace to which either happens gives the colour.
// This is [Saf88] in the form of [Pit07] and [Red12], with marks on edges as in [SV12]. Runs in rejecting components
// carry no brace, and a run that enters an accepting component starts a brace of its own there. Ours: the entries of a
// deterministic component start one each, so such a component is never determinised again; a state goes when another
// one simulates it in a component that comes later, or in the same one in a brace that is no worse.
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
