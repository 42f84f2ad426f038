// An accepted word of an automaton with any acceptance condition; none when the language is empty.
//
// In a component whose marks together satisfy the condition, a cycle through every mark accepts. Otherwise one mark
// under Fin is either removed with its edges, or given up (its Fin is false) and kept. [BBD+19]
#pragma once
#include <optional>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

// Shortest way to an accepting component, propositions that do not matter false. Exponential in the Fin marks that
// occur in one component, linear in the rest; the cycle has at most |component| · (marks + 1) letters.
std::optional<ltl::Lasso> find_lasso(const Automaton& automaton);
// … one step of budget for each edge that is looked at.
std::optional<ltl::Lasso> find_lasso(const Automaton& automaton, Budget& budget);

}  // namespace waymark::automata
