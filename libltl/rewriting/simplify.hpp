// Simplification under a given semantics: a smaller formula that holds on the same words.
//
// The kind of word decides which rules apply. A formula of a user is read on non-empty words, where F true is true. A
// formula that progression leaves may be read on the empty rest of a word, where F true means that another letter
// follows (docs/conventions.md 3). Inside a temporal operator every reading is of a position, so only the Boolean top
// differs: there a rule applies when both sides agree on the empty word. The rules are in rewrite_rules.hpp. Negations
// are pushed inwards first; equivalences are kept.
#pragma once
#include <cstdint>
#include <stop_token>

#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/rewriting/implication.hpp"

namespace waymark::ltl {

enum class Over : std::uint8_t {  // the words on which the meaning is kept
  Finite,                         // finite words, never empty: what a user states
  Rest,                           // finite words and the empty one: what progression leaves; accepts_empty is kept
  Infinite,                       // infinite words; N becomes X
};

// Idempotent; the tree never grows beyond that of nnf_keeping_iff(f). Passes over the DAG until nothing changes.
Formula simplify(Formula f, Over over);
// The rules may also ask whether one formula implies another one, over the same words. A requested stop, looked at
// before each rule, ends it early: what is returned then has the meaning of f and is less simple.
Formula simplify(Formula f, Over over, Implication::Oracle implies, const std::stop_token& stop = {});

inline Formula simplify(Formula f, Semantics semantics) {  // with the words of a user
  return simplify(f, semantics == Semantics::Finite ? Over::Finite : Over::Infinite);
}

}  // namespace waymark::ltl
