// Products of minimal automata over disjoint alphabets: when they are minimal, and how they are made without a search.
//
// Let L(q, n) be the words of length n that q accepts. Over disjoint alphabets a pair accepts, for "both must accept",
// the words of L(p, n) and L(q, n) put together letter by letter, and two such products of non-empty sets are equal
// only when their factors are. So if from some n on states of different diagrams differ in L(·, n), in either
// automaton, and only the trap has none, then pairs of different diagrams differ, but for those with a trap; dually for
// "either must accept" and the state that accepts everything. Pairs of the same diagrams differ when their verdicts do.
// Likewise pairs are reached independently: if from some n on all states of either automaton are reached by words of
// length n, then all pairs are. All this carries over to the pairs. An initial state that no word comes back to is
// left out: merge_initial() looks after it.
//
// When all pairs are reached, no two states have the same diagram, and one automaton asks for its propositions before
// the other one does, the diagrams of the pairs are copies: of the first for each root of the second, of the second
// for each state of the first.
#pragma once
#include <cstdint>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/product.hpp"

namespace waymark::automata {

// What holds from some length of words on. False also when that takes long to see.
struct AtEachLength {
  bool told_apart =
      false;  // states of different diagrams are; only the trap accepts nothing, dually for all words
  bool reached = false;    // all states are
  bool own_roots = false;  // at any length: no two states have the same diagram
};
// Of a minimal automaton. O(lengths looked at · diagram), a step of budget per node and length; throws what it throws.
AtEachLength at_each_length(const Transitions& minimal, Budget& budget);

// All variables of `first` stand above those of `second`, and all of the above holds of both. The verdict is "both" or
// "either". Throws what the budget throws. O(result).
Transitions disjoint_product(const Transitions& first, const Transitions& second, Verdict verdict,
                             Budget& budget);

// In a product of two automata that are told apart at each length only the initial state may be equivalent to another
// one. Then that becomes the initial one.
void merge_initial(Transitions& product, Budget& budget);

}  // namespace waymark::automata
