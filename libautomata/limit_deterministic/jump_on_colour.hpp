// Deterministic parity → limit-deterministic Büchi, by guessing the least colour that is met for ever.
//
// The initial part follows what is left of the language: the states of the parity automaton, those of one language
// being one. For each even colour c, the components of the automaton without colours below c are copied into the
// accepting part, edges of colour c marked. A jump leads to a copy of any state of the same language.
//
// Why that is sound for MDPs: under the strategy that is best for the parity automaton, almost every run comes into an
// end component of the product and stays, with one state set and one least colour; when that is even and c, jumping to
// the copy of the current state is accepted with probability one, and no word outside the language is ever accepted
// [SEJK16] with colours in place of formulas. A jump may lead to any state of the accepting part instead that
// accepts all words of the first target and only words of the language: the accepting part is deterministic, so what
// was accepted with probability one still is. And a state of the initial part whose whole language one such state
// accepts is that state: no jump is left to make.
#pragma once
#include <vector>

#include "libautomata/limit_deterministic/assembly.hpp"

namespace waymark::automata {

// parity(Min, Even, ·), deterministic, complete. Adds the copies to the accepting part; a jump for each state of each copy.
std::vector<Jump> jump_on_colour(const TransitionRelation& parity, AcceptingPart& accepting_part);

}  // namespace waymark::automata
