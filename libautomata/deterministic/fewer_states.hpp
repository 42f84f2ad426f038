// Merging of the states of a deterministic parity automaton that have one language, where colours exist for the result.
//
// All branches to q are redirected to a state r of the same language. Each state of the resulting structure still
// determines the residual language. Whether the structure can be coloured is decided in its product with the
// original automaton: colour 0 goes to the branches on no rejecting cycle; without them, colour 1 goes to the
// branches on no accepting cycle; and so on. No colouring exists when two successive rounds find no branch. Each
// round colours as many branches as possible, so a colouring is found where one exists, and with the fewest
// colours. A part of the product that has no colours shows that the whole has none: the pairs nearest to the merge,
// or the words of few letters. Letters are chosen that refute one merge by themselves; mostly they refute others.
// Ours; omega/recurrence.hpp has one round of this method on the structure of progression.
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
