// Products of minimal automata over disjoint alphabets: when they are minimal, and how they are made without a search.
//
// Let L(q, n) be the words of length n that q accepts. Over disjoint alphabets a pair accepts, for "both must accept",
// the words of L(p, n) and L(q, n) put together letter by letter, and two such products of non-empty sets are equal
// only when their factors are. So if from some n on the states of either automaton differ in L(·, n), and only the trap
// has none, then all pairs differ but those with a trap; dually for "either must accept" and the state that accepts
// everything. Likewise pairs are reached independently: if from some n on all states of either automaton are reached
// by words of length n, then all pairs are. Both properties carry over to the pairs. An initial state that no word
// comes back to, told from others by the empty word at most, is left out of both.
//
// When all pairs are reached and one automaton asks for its propositions before the other one does, the diagrams of the
// pairs are copies: of the first for each root of the second, of the second for each state of the first.
#pragma once
#include <cstdint>

#include "libautomata/effort.hpp"
#include "libautomata/product.hpp"
#include "libautomata/transitions.hpp"

namespace waymark::automata {

// What holds from some length of words on. False also when that takes long to see.
struct AtEachLength {
  bool told_apart =
      false;  // no two states accept the same words, only the trap none, only its opposite all of them
  bool reached = false;  // all states are
};
// O(lengths looked at · diagram).
AtEachLength at_each_length(const Transitions& minimal);

// All variables of `first` stand above those of `second`, and the states of both are all reached at each length. The
// verdict is "both" or "either". Throws what the effort throws. O(result).
Transitions disjoint_product(const Transitions& first, const Transitions& second, Verdict verdict,
                             Effort& effort);

// In a product of two automata that are told apart at each length only the initial state may be equivalent to another
// one. Then that becomes the initial one.
void merge_initial(Transitions& product);

}  // namespace waymark::automata
