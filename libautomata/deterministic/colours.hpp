// The fewest colours that the components of a deterministic parity automaton need. [CM99, Sec. 4]
//
// A component whose least colour is m gets the least height of m's parity that is no lower than those of its components
// without m. Heights read as max-parity; edges on no cycle get the lowest.
#pragma once
#include "libautomata/omega/branching.hpp"

namespace waymark::automata {

struct Recoloured {
  Branching automaton;
  bool weak = true;  // every component has one colour
};
// parity(Min, Even, ·) in and out; every state reachable.
Recoloured with_fewest_colours(const Branching& automaton);

// Of a branch: its mark, or n.
std::uint32_t colour_of(const Branching& automaton, Marks marks);
Marks mark_of(std::uint32_t colour, std::uint32_t sets);

// With a state that rejects for letters without a branch, if there are any.
Branching completed_parity(const Branching& automaton);

}  // namespace waymark::automata
