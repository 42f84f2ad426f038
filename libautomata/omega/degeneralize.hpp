// Generalised Büchi to Büchi with marks on states: copies of a state count how far a round through the sets has come.
//
// In a component, level l means that the sets before l in the order were met in this round; the copy at the last level
// accepts. Levels start afresh in every component, a component that needs no counting has none, and a branch into
// another component goes to a copy that exists. [BBDLF13, Sec. 4]
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct LevelRule {
  bool descending = false;   // sets are waited for from the last to the first
  bool look_ahead = false;   // marks that all branches of the target share count on arrival
  bool count_twice = false;  // … and again when they are taken after acceptance
};

// Generalised Büchi with marks on edges in, Büchi out; all branches of a state carry the same marks.
// One state of budget per copy.
TransitionRelation degeneralize(const TransitionRelation& automaton, const LevelRule& rule, Budget& budget);

// A set on all branches where every run accepts and there is none.
TransitionRelation with_one_set(TransitionRelation automaton);

}  // namespace waymark::automata
