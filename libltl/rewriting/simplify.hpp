// Rewriting under a named semantics, to a smaller formula that is true of the same words.
//
// Which words is the whole question. A formula as someone states it is read on non-empty words, and there F true is
// true. What progression leaves to do may be read on the empty rest of a word, and there F true says "more to come"
// (docs/conventions.md 3). Inside a temporal operator every reading is of a position, so this concerns the Boolean
// top layer only: there a rule is applied when both sides say the same of the empty word.
// The rules: rewrite_rules.hpp. Negations are pushed inwards first, equivalences kept.
#pragma once
#include <cstdint>

#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/implication.hpp"

namespace waymark::ltl {

enum class Over : std::uint8_t {
  Finite,    // finite words, never empty: what a user states
  Rest,      // finite words and the empty one: what progression leaves; accepts_empty is kept
  Infinite,  // infinite words; N becomes X
};

// Idempotent; the tree never grows beyond that of nnf_keeping_iff(f). Passes over the DAG until nothing changes.
Formula simplify(Formula f, Over over);
// The rules may also ask whether one formula implies another one, over the same words.
Formula simplify(Formula f, Over over, Implication::Oracle implies);

inline Formula simplify(Formula f, Semantics semantics) {
  return simplify(f, semantics == Semantics::Finite ? Over::Finite : Over::Infinite);
}

}  // namespace waymark::ltl
