// The fewest colours that the components of a deterministic parity automaton need. [CM99, Sec. 4]
//
// A component whose least colour is m gets the least height of the parity of m that is not below the heights of its
// subcomponents without m. Heights are read as max-parity. Edges on no cycle get the lowest height.
#pragma once
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Recoloured {
  TransitionRelation automaton;  // with the new colours
  bool weak = true;              // every component has one colour
};
// parity(Min, Even, ·) in and out; every state reachable.
Recoloured with_fewest_colours(const TransitionRelation& automaton);

// Of a branch: its mark, or n.
std::uint32_t colour_of(const TransitionRelation& automaton, Marks marks);
Marks mark_of(std::uint32_t colour, std::uint32_t sets);

// With a state that rejects for letters without a branch, if there are any.
TransitionRelation completed_parity(const TransitionRelation& automaton);

}  // namespace waymark::automata
