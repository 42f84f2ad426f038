// Past operators as propositions of their own: φ with past becomes φ' without, over more propositions.
//
// Every past subformula has a proposition in φ', its history, and φ' says how histories go on from letter to letter:
//   Y ψ    not at first;          at the next letter exactly where ψ holds now
//   ψ S χ  exactly as χ at first; at the next letter exactly where χ does, or ψ does and the history holds now
// Each word has exactly one choice of histories that satisfies these, so a word satisfies φ exactly when the word with
// its histories satisfies φ'. An automaton of φ' that forgets the histories is an automaton of φ; where `determined`, a
// history is known from the letters read so far, and a trimmed deterministic automaton stays deterministic. Both kinds
// of words. Source: the temporal testers of [KPR98, Sec. 3].
#pragma once
#include "libltl/formula.hpp"

namespace waymark::ltl {

struct WithoutPast {
  Formula formula;  // φ', in the arena that was given
  bool determined;  // no operator of the future stands below one of the past
};

// `to` starts with the vocabulary of f's arena and gains the histories at the end. O(DAG).
WithoutPast without_past(Formula f, Arena& to);

}  // namespace waymark::ltl
