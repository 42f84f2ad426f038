// Progression: the formula that the rest of a word must satisfy after one letter. Progression gives the states of
// automata, the reward of learners, and the task component of a Q-learning state.
//
//   a·w ⊨ φ  iff  w ⊨ prog(φ, a)        for every letter a and every rest w, the empty one included, where
//   ε ⊨ φ    iff  accepts_empty(φ):      G, R, N, true and ¬φ with ε ⊭ φ hold, F, U, X, Y, S, false and atoms do not.
// Finite words keep the two next operators apart: prog(X φ) = φ ∧ F true, prog(N φ) = φ ∨ G false.
// Past operators stay in the formula, which then remembers the letter: Y φ becomes Y φ' ∨ (first ∧ prog(φ, a)), where
// first = ¬Y true and φ' is φ treated likewise; S by its expansion. Without future operators below past ones, finitely
// many formulas arise up to propositional identities. Source: [BK00, Table 1] for infinite words, [DV13] for finite
// ones; the end-of-word test and the past are ours (docs/conventions.md 2).
#pragma once
#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/word.hpp"

namespace waymark::ltl {

Formula progress(Formula f, const Letter& letter, Semantics semantics = Semantics::Finite);  // O(DAG)
bool accepts_empty(Formula f);                                                               // ε ⊨ φ, O(DAG)

}  // namespace waymark::ltl
