// States of one language as one state, where colours can be found for what remains.
//
// Let every branch to q lead to r, which accepts the same words. What is left is a structure whose states still know
// what remains to be read, and whether colours can be put on it is decided in the product with the automaton of before:
// colour 0 goes to the branches that lie on no rejecting cycle; without them, colour 1 to those on no accepting one;
// and so on. When a round of two finds none there is no such colouring. When there is one, this finds it, and with the
// fewest colours: the branches of a colour are as many as they can be. Ours; for one round of this on the structure of
// progression see omega/recurrence.hpp.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/reduce.hpp"

namespace waymark::automata {

// parity(Min, Even, ·) in and out, deterministic; complete when something was merged. States are tried pair by pair.
// Never throws Budget::Exceeded except when stopped: what was reached is returned.
Reduced with_fewer_states(const TransitionRelation& automaton, Budget& budget);
// … of a complete automaton whose languages() are known.
Reduced with_fewer_states(const TransitionRelation& complete, const std::vector<std::uint32_t>& language,
                          Budget& budget);

}  // namespace waymark::automata
