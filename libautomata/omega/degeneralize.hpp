// Generalised Büchi to Büchi automata with marks on states: copies of a state count the sets met in a round.
//
// In a component, level l means that this round has met the sets before l in the order. The copy at the last level
// accepts. Levels restart in every component, and a component that needs no counting has none. A branch into another
// component goes to an existing copy. [BBDLF13, Sec. 4]
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct LevelRule {           // the order of the sets, and where levels begin
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
