// The assembly of a limit-deterministic automaton: the states of the initial part and their jumps.
//
// The initial part is a deterministic automaton without acceptance that follows the residual language; states of one
// language are one. A jump leads from such a state to a state of the accepting part. The language after a jump must be
// contained in the language of its source, and the jumps together must be sound for MDPs. jump_on_colour.hpp has the
// proof, and the reason why two freedoms keep soundness:
//   a jump may go to any state that accepts at least as much, and no more than the residual language;
//   a state whose whole language one such state accepts is replaced by that state.
#pragma once
#include <vector>

#include "libautomata/limit_deterministic/accepting_part.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"

namespace waymark::automata {

struct Jump {          // from the initial part to the accepting part
  std::uint32_t from;  // a state of the deterministic automaton
  std::uint32_t to;    // one of the accepting part, L(to) ⊆ L(from)
  bool exact = false;  // known: L(to) = L(from)
};

// An automaton for each list of jumps. parity: complete, deterministic, parity(Min, Even, ·). compare: languages are
// compared, one step of budget per pair of nodes, for all pairs of states; else states and jumps stay as they are.
// Canonical numbering.
std::vector<LimitDeterministic> assembled(const TransitionRelation& parity, const AcceptingPart& accepting_part,
                                          std::vector<std::vector<Jump>> jumps, bool compare, Budget& budget);

}  // namespace waymark::automata
