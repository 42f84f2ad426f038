// Removal of states and marks that no accepting run uses, component by component.
//
// States that no accepting run visits are removed, and marks outside accepting components. Inside a component, a branch
// gets mark i when every cycle through the branch has mark i (its ends fall into different components without the
// branches of i). A set implied by another set is then dropped, and the others are renumbered, so the number of sets is
// that of the component that needs most. [BBDLF13, Sec. 3], the saturation is ours.
#pragma once
#include <optional>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

enum class MarksOn : std::uint8_t { Edges, States };  // States: all branches of a state carry the same marks

// Without what no accepting run visits; any condition. One state without branches when nothing is accepted.
TransitionRelation trim(const TransitionRelation& automaton);

// Generalised Büchi in (std::invalid_argument otherwise), generalised Büchi out. The empty language is one state
// without branches. With marks on states sets stay as they are, and a state gets mark i when no cycle through it avoids
// the states that have it.
TransitionRelation scc_filter(const TransitionRelation& automaton, MarksOn marks, Budget& budget);

// All marks on all branches that leave their component: a run takes such ones finitely often. scc_filter takes them off
// again; in between, states may be equal that were not. nullopt where nothing changes.
std::optional<TransitionRelation> with_free_marks(const TransitionRelation& automaton);

// One state without branches.
TransitionRelation nothing_accepted();

}  // namespace waymark::automata
