// Products of minimal automata over disjoint alphabets: when they are minimal, and their construction without a search.
//
// Let L(q, n) be the words of length n that q accepts. Over disjoint alphabets, a pair (p, q) of a conjunction accepts
// the letter-by-letter combinations of L(p, n) and L(q, n), and two such sets are equal only when their factors are
// equal or one factor is empty. Assume that from some n on, in either automaton, states of different diagrams differ in
// L(·, n), and only the trap has an empty one. Then pairs of different diagrams differ, except pairs with a trap. The
// dual holds for disjunctions and the state that accepts everything. Pairs of the same diagrams differ when their
// verdicts do. Likewise, if from some n on all states of either automaton are reached by words of length n, then all
// pairs are reached. Both properties carry over to the product. An initial state to which no word returns is left out;
// merge_initial() treats it.
//
// When all pairs are reached, no two states have the same diagram, and one automaton tests its propositions before the
// other, the diagrams of the pairs are copies: of the first for each root of the second, of the second for each state
// of the first.
#pragma once
#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/product.hpp"

namespace waymark::automata {

// What holds from some length of words on. False also when that takes long to see.
struct AtEachLength {
  bool told_apart = false;  // states of different diagrams are; only the trap accepts nothing, dually for all words
  bool reached = false;     // all states are
  bool own_roots = false;   // at any length: no two states have the same diagram
};
// Of a minimal automaton. O(lengths looked at · diagram), a step of budget per node and length; throws what it throws.
AtEachLength at_each_length(const Transitions& minimal, Budget& budget);

// All variables of `first` stand above those of `second`, and all of the above holds of both. The verdict is "both" or
// "either". Throws what the budget throws. O(result).
Transitions disjoint_product(const Transitions& first, const Transitions& second, Verdict verdict, Budget& budget);

// In a product of two automata that are told apart at each length only the initial state may be equivalent to another
// one. Then that becomes the initial one.
void merge_initial(Transitions& product, Budget& budget);

}  // namespace waymark::automata
