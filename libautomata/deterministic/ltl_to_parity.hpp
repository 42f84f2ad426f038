// LTL over infinite words → deterministic automata with parity, Rabin or any condition.
//
// Obligations by their minimal weak automaton. A Boolean combination also by the product of deterministic automata of
// its parts, made a parity automaton only then. Else the generalised Büchi automata of φ and of ¬φ, complemented: as
// they are where they come out deterministic, and determinised. The smallest one stays.
#pragma once
#include <variant>

#include "libautomata/deterministic/parity.hpp"
#include "libautomata/ltlf_to_dfa.hpp"
#include "libautomata/omega/ltl_to_buchi.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

// Deterministic, trimmed, canonical numbering: same formula, same bytes. Exhausted when both routes met a limit.
std::variant<Translated, Exhausted> ltl_to_parity(ltl::Formula f, const TranslationLimits& limits);
std::variant<Translated, Exhausted> ltl_to_rabin(ltl::Formula f, const TranslationLimits& limits);
// Any condition: a deterministic generalised (co-)Büchi automaton where that is smaller.
std::variant<Translated, Exhausted> ltl_to_generic(ltl::Formula f, const TranslationLimits& limits);

// Without limits; std::length_error when a formula is too large for one automaton.
Dpa ltl_to_dpa(ltl::Formula f);

}  // namespace waymark::automata
