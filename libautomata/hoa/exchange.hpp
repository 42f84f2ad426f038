// Automata in the formats of other tools: Spin's never claims, LBTT, BA, and a plain table.
//
// A function returns nullopt when there are more edges than the limit, or a guard has more cubes; both are counted
// first. Never claims and BA describe Büchi automata with accepting states, LBTT generalised Büchi conditions. For
// other automata the functions throw std::invalid_argument; make_state_based() converts where possible.
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

// Büchi with the same marks on all edges of a state: of a generalised Büchi automaton, by copies of its states where
// needed. nullopt for other conditions. Throws what the budget throws.
std::optional<Automaton> make_state_based(const Automaton& automaton, Budget& budget);

// Büchi, marks on states. Propositions that are no identifiers of Promela are put in parentheses, as they are.
std::optional<std::string> write_never_claim(const Automaton& automaton, std::size_t most_edges,
                                             const std::string& name = {});
// Generalised Büchi, marks on edges ("t"), guards in prefix notation.
std::optional<std::string> write_lbtt(const Automaton& automaton, std::size_t most_edges);
// Büchi, marks on states. The format has letters and no guards: an edge for each letter, written as "a&!b". Where no
// state accepts, one that is not reached does, since a file without accepting states means that all of them are.
std::optional<std::string> write_ba(const Automaton& automaton, std::size_t most_edges);
// A heading, then one edge a line: source, target, marks with commas or "-", guard in ASCII notation. State 0 is
// initial.
std::optional<std::string> write_table(const Automaton& automaton, std::size_t most_edges);

}  // namespace waymark::automata
