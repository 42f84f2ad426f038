// Alternating automata, and the removal of their universal branches.
//
// On a letter, a state offers edges. An edge leads to several states, all of which must accept the rest. The breakpoint
// construction of [MH84] follows the set S of active states and the set O ⊆ S of those that have not met a mark since
// the last breakpoint. When O becomes empty, the edge is marked and O becomes S. Here marks are on edges, and the
// alternatives of a set are one diagram. Of two alternatives with S₁ ⊆ S₂ and O₁ ⊆ O₂, the second is dropped, because
// the first accepts every word that the second accepts.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// Alternating Büchi automaton: a run accepts when each of its branches meets infinitely many marked edges.
struct AlternatingBuchi {
  struct Edge {                          // to all of its targets together
    Mtbdd::Node label;                   // over diagram, Boolean
    std::vector<std::uint32_t> targets;  // sorted, unique, not empty
    bool marked = false;                 // accepting
  };
  Mtbdd diagram;                                   // of the labels
  std::vector<std::vector<Edge>> edges;            // by state
  std::vector<std::vector<std::uint32_t>> starts;  // conjunctions; several: nondeterminism
};

// A nondeterministic Büchi automaton of the same language; at most 3ⁿ states. One state and some steps of budget for
// each. The variables stay.
TransitionRelation without_alternation(AlternatingBuchi automaton, Budget& budget);

}  // namespace waymark::automata
