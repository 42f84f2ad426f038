// LTL over infinite words → limit-deterministic Büchi automata that are sound for MDPs.
#pragma once
#include <variant>

#include "libautomata/deterministic/parity.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

struct TranslatedForMdps {  // an automaton, and whether more could be done
  MdpSafe automaton;        // accepts the words of the formula
  bool reduced = true;      // false: some reduction ran out of budget, the automaton may be larger than need be
};

// Canonical numbering: same formula, same bytes.
std::variant<TranslatedForMdps, Exhausted> ltl_to_ldba(ltl::Formula f, const ltl::Limits& limits);
// Without limits; std::length_error when a formula is too large for one automaton.
MdpSafe ltl_to_ldba(ltl::Formula f);

// The same for a deterministic automaton that was read from a file.
MdpSafe limit_deterministic(const Dpa& automaton);

}  // namespace waymark::automata
