// Marks that no accepting run needs, taken off: the opposite of what scc_filter does, and what counting levels wants.
#pragma once
#include <optional>

#include "libautomata/effort.hpp"
#include "libautomata/omega/branching.hpp"

namespace waymark::automata {

// A branch loses mark i when every cycle through it meets i on another branch too. One at a time, in the order of
// (source, target, marks), so of several that could go some stay. Generalised Büchi in and out, the same language.
// O(marked branches · branches). nullopt when there is none to lose.
std::optional<Branching> fewest_marks(const Branching& automaton, Effort& effort);

}  // namespace waymark::automata
