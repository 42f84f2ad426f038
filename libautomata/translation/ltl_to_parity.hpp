// LTL over infinite words → deterministic automata with parity, Rabin or any condition.
//
// Obligations by their minimal weak automaton. For the rest, in this order: conjunctions of G F e and their negations
// directly; Boolean combinations by the product of deterministic automata of their parts, made a parity automaton only
// then; the generalised Büchi automata of φ and of ¬φ where they come out deterministic; both determinised; where that
// has found nothing small, the normal form in Δ₂ [ERS24] as one more Boolean combination, if all of its parts come
// without determinisation. The smallest one stays, and the search ends where one is proved minimal.
#pragma once
#include <variant>

#include "libautomata/deterministic/parity.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

// Deterministic, trimmed, canonical numbering: same formula, same bytes. Exhausted when no route came to an end; when
// the stop is requested after one did, its automaton is the answer, not reduced.
std::variant<Translated, Exhausted> ltl_to_parity(ltl::Formula f, const TranslationLimits& limits);
std::variant<Translated, Exhausted> ltl_to_rabin(ltl::Formula f, const TranslationLimits& limits);
// Any condition: generalised (co-)Büchi, or the condition of a product, where that is smaller.
std::variant<Translated, Exhausted> ltl_to_generic(ltl::Formula f, const TranslationLimits& limits);

// Without limits; std::length_error when a formula is too large for one automaton.
Dpa ltl_to_dpa(ltl::Formula f);

}  // namespace waymark::automata
