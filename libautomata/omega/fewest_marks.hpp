// Removal of marks that no accepting run needs. Degeneralisation prefers few marks, and scc_filter adds marks instead.
#pragma once
#include <optional>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// A branch loses mark i when every cycle through it meets i on another branch too. One at a time, in the order of
// (source, target, marks), so of several that could go some stay. Generalised Büchi in and out, the same language.
// O(marked branches · branches). nullopt when there is none to lose.
std::optional<TransitionRelation> fewest_marks(const TransitionRelation& automaton, Budget& budget);

}  // namespace waymark::automata
