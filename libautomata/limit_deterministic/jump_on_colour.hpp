// Deterministic parity → limit-deterministic Büchi automata: a jump selects the least colour that occurs infinitely
// often.
//
// The initial part follows the residual language: the states of the parity automaton, those of one language being one.
// For each even colour c, the components of the automaton without colours below c are copied into the accepting part,
// and edges of colour c are marked. A jump leads to a copy of any state of the same language.
//
// Soundness for MDPs: under an optimal strategy for the parity automaton, almost every run stays in an end component of
// the product with one set of states and one least colour. When that colour is even and c, the run is accepted with
// probability one after a jump to the copy of the current state, and no word outside the language is accepted [SEJK16],
// with colours instead of formulas. A jump may instead lead to any state of the accepting part that accepts all words
// of the first target and only words of the language: the accepting part is deterministic, so acceptance with
// probability one is kept. A state of the initial part whose whole language one such state accepts is replaced by that
// state.
#pragma once
#include <vector>

#include "libautomata/limit_deterministic/assembly.hpp"

namespace waymark::automata {

// parity(Min, Even, ·), deterministic, complete. Adds the copies to the accepting part; a jump for each state of each
// copy.
std::vector<Jump> jump_on_colour(const TransitionRelation& parity, AcceptingPart& accepting_part);

}  // namespace waymark::automata
