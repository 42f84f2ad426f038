// LTL over infinite words → generalised Büchi automata with marks on edges, and Büchi automata with marks on states.
//
// Three routes, the smallest result is kept: the tableau, reduced; the minimal weak deterministic automaton, when the
// formula is an obligation by its syntax, or when that automaton turns out to have φ's language (its product with the
// tableau of ¬φ, and its complement's with that of φ, are empty); and the product of the automata of a conjunction's
// operands, reduced at every step, for the operands as they were stated and as rewriting left them. At the end states
// are made one wherever that leaves the language as it is (state_merging.hpp).
#pragma once
#include <cstddef>
#include <stop_token>
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

struct Translated {
  Automaton
      automaton;  // trimmed: some word is accepted from every state, unless none is from the initial one
  bool reduced = true;  // false: some reduction ran out of budget, the automaton may be larger than need be
};

// Canonical numbering: same formula, same bytes. Büchi automata have one set, on all branches of accepting states.
std::variant<Translated, Exhausted> ltl_to_tgba(ltl::Formula f, const TranslationLimits& limits);
std::variant<Translated, Exhausted> ltl_to_buchi(ltl::Formula f, const TranslationLimits& limits);

// Without limits; std::length_error when a formula is too large for one automaton.
Automaton ltl_to_tgba(ltl::Formula f);
Automaton ltl_to_buchi(ltl::Formula f);

}  // namespace waymark::automata
