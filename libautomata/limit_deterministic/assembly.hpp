// From jumps to a limit-deterministic automaton: which states the initial part keeps and where it jumps.
//
// The initial part is a deterministic automaton of the language without its acceptance, states of one language being
// one. A jump says: a run that is in this state may jump to that state of the accepting part. Whatever is accepted after the jump
// must be in the language of the state, and the jumps together must be sound for MDPs (jump_on_colour.hpp has the
// argument, and why the two freedoms that are taken here keep it):
//   a jump may go to any state that accepts at least as much, and no more than the language left;
//   a state whose whole language is accepted by one such state is replaced by it.
#pragma once
#include <vector>

#include "libautomata/limit_deterministic/accepting_part.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"

namespace waymark::automata {

struct Jump {
  std::uint32_t from;  // a state of the deterministic automaton
  std::uint32_t to;    // one of the accepting part, L(to) ⊆ L(from)
  bool exact = false;  // known: L(to) = L(from)
};

// An automaton for each list of jumps. parity: complete, deterministic, parity(Min, Even, ·). compare: languages are
// compared, one step of budget per pair of nodes, for all pairs of states; else states and jumps stay as they are.
// Canonical numbering.
std::vector<LimitDeterministic> assembled(const TransitionRelation& parity,
                                          const AcceptingPart& accepting_part,
                                          std::vector<std::vector<Jump>> jumps, bool compare, Budget& budget);

}  // namespace waymark::automata
