// A model with labels on states: what questions about all of its states need of it.
//
// An Mdp of PRISM's language or of JANI enters every state with one letter. Such a model can begin anywhere, and what
// was found of its states can become a proposition of it.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/solve/end_components.hpp"

namespace waymark::plan {

using StateTruth = std::pair<std::string, std::vector<bool>>;  // a proposition, and whether it holds, by state

// By state, the letter that its entries carry. Precondition: all carry one. The initial state has that of the start.
std::vector<LetterId> letters_of_states(const Mdp& mdp);

// The part that is reachable from a state, which becomes state 0, with more propositions. O(outcomes).
Mdp beginning_at(const Mdp& mdp, std::uint32_t start, const std::vector<LetterId>& letters,
                 const std::vector<StateTruth>& more = {});

// Places and what was spent on the way to them: the proposition `within` holds as long as that is at most the budget;
// then everything ends in one state without propositions. Costs are 0 there. O(states · budget) at most, in memory too.
// Throws std::invalid_argument for a cost that is no whole number. nullopt: more states than the limit, or stopped.
std::optional<Mdp> spending(const Mdp& mdp, std::uint64_t budget, const std::string& within, const ltl::Limits& limits);

// The end components of the whole model, or those of the choices that are usable(state, choice).
EndComponents end_components_of(const Mdp& mdp, const std::function<bool(std::uint32_t, std::uint32_t)>& usable = {});

// May the choice leave the end component of its state?
bool leaves(const Mdp& mdp, std::uint32_t s, std::uint32_t k, const EndComponents& components);

// The model in which every end component is one state, with a choice that ends in a last state, where "end" holds.
// Costs and the other choices stay. A strategy of the one has a strategy of the other whose runs cost the same, as long
// as choices within end components cost nothing. State 0 begins.
Mdp ending_in_components(const Mdp& mdp, const EndComponents& components);

// The states in which a strategy can stay without any cost for ever, whatever the outcomes.
std::vector<bool> free_for_ever(const Mdp& mdp);

}  // namespace waymark::plan
