// Redirection of branches between states of a deterministic automaton that have one language.
//
// Acceptance does not depend on the state of a language class in which a run starts. A branch may therefore lead to
// another state of its target's class in a later component. A run is redirected finitely often, and a run of the
// original automaton meets the same marks for ever. Components that only led to later ones become unreachable.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// By state: the first state that accepts the same words. Deterministic, complete, any acceptance. A few words tell most
// states apart; of the others all pairs are compared: one step of budget per pair of nodes.
std::vector<std::uint32_t> languages(const TransitionRelation& complete, Budget& budget);

// Deterministic and complete; `language` as languages() gives it. States may be left that nothing reaches; nullopt when
// every branch stays where it is.
std::optional<TransitionRelation> one_component_each(const TransitionRelation& complete,
                                                     const std::vector<std::uint32_t>& language);

}  // namespace waymark::automata
