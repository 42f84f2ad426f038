// Reduction of generalised Büchi automata by components and by simulation in both directions, until a fixed point. The
// cheapest useful step goes first: states are merged, then branches are pruned, then both are tried with other marks.
#pragma once
#include "libautomata/budget.hpp"
#include "libautomata/omega/scc_filter.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Reduced {                 // an automaton, and whether more could be done
  TransitionRelation automaton;  // of the same language
  bool complete = true;          // false: the budget ran out; the automaton is valid, and larger than it could be
};

// Never throws Budget::Exceeded except when stopped: what was reached is returned.
Reduced reduce(TransitionRelation automaton, MarksOn marks, Budget& budget);

// The same for marks on edges as a construction gave them. Marks that scc_filter adds let some states simulate others,
// and tell apart some that were equal: where they do, and where the result is small, states are merged and branches
// pruned by the given marks first.
Reduced reduce_as_marked(const TransitionRelation& automaton, Budget& budget);

}  // namespace waymark::automata
