// From guesses to a limit-deterministic automaton: which states the initial part keeps and where it jumps.
//
// The initial part is a deterministic automaton of the language without its acceptance, states of one language being
// one. A guess says: a run that is in this state may jump to that state of the pool. Whatever is accepted after the jump
// must be in the language of the state, and the guesses together must be sound for MDPs (guess_colour.hpp has the
// argument, and why the two freedoms that are taken here keep it):
//   a jump may go to any state that accepts at least as much, and no more than the language left;
//   a state whose whole language is accepted by one such state is replaced by it.
#pragma once
#include <vector>

#include "libautomata/limit_deterministic/ldba.hpp"
#include "libautomata/limit_deterministic/pool.hpp"

namespace waymark::automata {

struct Guess {
  std::uint32_t from;  // a state of the deterministic automaton
  std::uint32_t to;    // one of the pool, L(to) ⊆ L(from)
  bool exact = false;  // known: L(to) = L(from)
};

// An automaton for each list of guesses. parity: complete, deterministic, parity(Min, Even, ·). compare: languages are
// compared, one step of effort per pair of nodes, for all pairs of states; else states and guesses stay as they are.
// Canonical numbering.
std::vector<LimitDeterministic> hosted(const Branching& parity, const Pool& pool,
                                       std::vector<std::vector<Guess>> guesses, bool compare, Effort& effort);

}  // namespace waymark::automata
