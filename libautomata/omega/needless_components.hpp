// Components that a run may as well stay out of.
//
// Simulation asks for every mark at once, so a branch that leaves for a small component may look better than one that
// stays and marks later. Here a component goes when each branch into it has a rival, another branch of its choice to a
// state that can do as much, and the automaton without the component is seen to accept what the whole one does: its
// initial state simulates the old one. A run leaves a component finitely often, so for this relation branches that
// leave demand no marks of what simulates them, and have all marks themselves. The removal is ours.
#pragma once
#include "libautomata/effort.hpp"
#include "libautomata/omega/branching.hpp"
#include "libautomata/omega/reduce.hpp"

namespace waymark::automata {

// Reduced again when a component went, until none goes. What reduce() made of marks on edges in, the same language.
// Never throws Spent except when stopped: what was reached is returned.
Reduced without_needless_components(Branching automaton, Effort& effort);

}  // namespace waymark::automata
