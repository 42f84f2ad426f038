// LTL over infinite words → deterministic automata with parity, Rabin or any condition.
//
// Obligations have their minimal weak automaton. Other formulas try these constructions in order: conjunctions of G F e
// and their negations directly; the product of deterministic automata of the parts of a Boolean combination, made
// parity at the end; the generalised Büchi automata of φ and of ¬φ where they are deterministic; both determinised;
// where no small automaton was found, the normal form in Δ₂ [ERS24] as one more Boolean combination, if no part needs
// determinisation. The smallest automaton is kept, and the search ends where one is proved minimal.
#pragma once
#include <variant>

#include "libautomata/deterministic/parity.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

// Deterministic, trimmed, canonical numbering: same formula, same bytes. Exhausted when no route came to an end; when
// the stop is requested after one did, its automaton is the answer, not reduced.
std::variant<Translated, Exhausted> ltl_to_parity(ltl::Formula f, const ltl::Limits& limits);
std::variant<Translated, Exhausted> ltl_to_rabin(ltl::Formula f, const ltl::Limits& limits);
// Any condition: generalised (co-)Büchi, or the condition of a product, where that is smaller.
std::variant<Translated, Exhausted> ltl_to_generic(ltl::Formula f, const ltl::Limits& limits);

// Without limits; std::length_error when a formula is too large for one automaton.
Dpa ltl_to_dpa(ltl::Formula f);

}  // namespace waymark::automata
