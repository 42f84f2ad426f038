// States of a deterministic automaton with one language, and what they allow: each language in one component only.
//
// Whether a word is accepted does not depend on where a run starts among states of one language. So a branch may lead
// to another state of its target's language in a component that comes later: a run is sent on finitely often, and what
// it meets for ever is met by a run of the original. What only served to find the right component goes away.
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
