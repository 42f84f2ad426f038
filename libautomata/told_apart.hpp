// When the product of minimal automata over disjoint alphabets is minimal.
//
// L(q, n) are the words of length n that q accepts. A pair over disjoint alphabets accepts at length n, for "both must
// accept", the products of the words of L(p, n) and L(q, n), letter by letter; two products of non-empty sets are equal
// only when their factors are. So if from some n on the states of either automaton differ in L(·, n), and only the trap
// has none, then all pairs differ but those with a trap; dually for "either must accept" and the state that accepts
// everything. The pairs have the property again. How the states compare at length n + 1 follows from how they do at
// length n (and the diagrams), which is what is computed here; an initial state that no word comes back to, told
// from others by the empty word at most, is left out of it.
#pragma once
#include "libautomata/transitions.hpp"

namespace waymark::automata {

// From some length on: no two states accept the same words of that length, only a state that accepts no word at all
// accepts none of them, and only one that accepts every word all of them. False also when that takes long to see.
// O(lengths looked at · diagram). The automaton is minimal.
bool told_apart_at_each_length(const Transitions& minimal);

// In the product of two such automata over disjoint alphabets, for a verdict "both" or "either": the state that the
// initial one is equivalent to, or itself.
std::uint32_t initial_class(const Transitions& product);

}  // namespace waymark::automata
