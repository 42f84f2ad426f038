// Does a formula have the shape of a phrase, and what stands for the letters of the phrase?
#pragma once
#include <optional>
#include <span>

#include "libltl/english/description.hpp"
#include "libltl/english/phrase.hpp"

namespace waymark::ltl {

bool is_literal(Formula f);       // p, ¬p, true, false
bool is_state_clause(Formula f);  // a Boolean combination of literals, at most two levels deep
// May f stand in the slot? `words`: of each proposition.
bool fits(Formula f, Slot slot, std::span<const Described> words);

// The parts of f under the phrase. Operands of ∧ and ∨ may be in any order; a letter for a state takes all operands that
// are states, a letter of any formula takes those that are left.
std::optional<Bindings> match(const Phrase& phrase, Formula f, std::span<const Described> words);

}  // namespace waymark::ltl
