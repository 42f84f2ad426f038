// Recurrence properties: a deterministic Büchi automaton on the structure that progression gives.
//
// On the product of the structure with an automaton of ¬φ, the edges inside accepting components are those that some
// rejected word takes for ever. All others are marked: a word that takes a marked edge again and again satisfies φ.
// Whether every word of φ does so depends on the structure and is checked.
#pragma once
#include <optional>

#include "libautomata/effort.hpp"
#include "libautomata/omega/branching.hpp"
#include "libautomata/transitions.hpp"

namespace waymark::automata {

// yes, no: generalised Büchi automata of φ and ¬φ. nullopt when the structure cannot carry the marks.
std::optional<Branching> deterministic_buchi(const Transitions& structure, const Branching& yes,
                                             const Branching& no, Effort& effort);

}  // namespace waymark::automata
