// LTL over infinite words → generalised Büchi automata with marks on edges, and Büchi automata with marks on states.
//
// Three constructions are tried, and the smallest result is kept. The first is the reduced tableau. The second is the
// minimal weak deterministic automaton, when the formula is an obligation by its syntax, or when that automaton has the
// language of φ (its product with the tableau of ¬φ, and that of its complement with φ's, are empty). The third is the
// product of the automata of the operands of a conjunction, reduced at every step, for the operands as stated and as
// rewritten. State merging follows (state_merging.hpp).
#pragma once
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

struct Translated {     // an automaton, and whether more could be done
  Automaton automaton;  // trimmed: some word is accepted from every state, unless none is from the initial one
  bool reduced = true;  // false: some reduction ran out of budget, the automaton may be larger than need be
};

// Canonical numbering: same formula, same bytes. Büchi automata have one set, on all branches of accepting states.
std::variant<Translated, Exhausted> ltl_to_tgba(ltl::Formula f, const ltl::Limits& limits);
std::variant<Translated, Exhausted> ltl_to_buchi(ltl::Formula f, const ltl::Limits& limits);

// Of a formula with past operators, from that of the formula in which these are propositions (without_past.hpp): the
// propositions that `names` lacks are forgotten, and the automaton is reduced. In forget_histories.cpp.
std::variant<Translated, Exhausted> forget_histories(std::variant<Translated, Exhausted> found,
                                                     const ltl::Vocabulary& names, bool buchi,
                                                     const ltl::Limits& limits);

// Without limits; std::length_error when a formula is too large for one automaton.
Automaton ltl_to_tgba(ltl::Formula f);
Automaton ltl_to_buchi(ltl::Formula f);

}  // namespace waymark::automata
