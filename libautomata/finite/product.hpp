// Products of DFAs: both automata read the same word, and a Boolean function of their verdicts decides.
//
// States are pairs, created when reached. One apply merges the two diagrams, and its leaf operation numbers pairs, so
// the cost follows shared nodes and not letters. All pairs in which one component fixes the verdict are one state.
// Source: [BK08, Sec. 4.1] for the pairs.
#pragma once
#include <optional>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"

namespace waymark::automata {

using Verdict = bool (*)(bool first, bool second);  // of a pair

// A settling state: a state that is never left and whose acceptance fixes the verdict of every pair that contains it.
// `first` says whether `automaton` is the first or the second automaton of the product.
std::optional<std::uint32_t> settling_state(const Transitions& automaton, Verdict verdict, bool first);

// The product of two automata over the same variables. Pairs with the same diagrams and the same verdict are one state;
// the result is not minimised further. The function throws what the budget throws.
// `Disjoint` is a promise of the caller that saves time: no variable occurs in both automata, and in each automaton
// different states that letters lead to have different diagrams.
enum class Alphabets : std::uint8_t { Any, Disjoint };
Transitions product(const Transitions& a, const Transitions& b, Verdict verdict, Budget& budget,
                    Alphabets alphabets = Alphabets::Any);

// Propositions are matched by name. The vocabulary of the product is a's, followed by what b adds. No DFA accepts the
// empty word, so verdict(false, false) must be false; the function throws std::invalid_argument otherwise.
Dfa product(const Dfa& a, const Dfa& b, Verdict verdict, Budget& budget);
inline Dfa product(const Dfa& a, const Dfa& b, Verdict verdict) {
  Budget unlimited;
  return product(a, b, verdict, unlimited);
}

// A shortest word on which the two differ, over the vocabulary of their product; nullopt: they are equivalent.
struct Difference {
  ltl::Vocabulary vocabulary;  // of both automata together
  ltl::Trace word;             // one of the shortest
  bool first_accepts = false;  // and the other rejects
};
// A shortest word on which a and b differ; nothing when they are equivalent.
std::optional<Difference> difference(const Dfa& a, const Dfa& b, Budget& budget);
inline std::optional<Difference> difference(const Dfa& a, const Dfa& b) {
  Budget unlimited;
  return difference(a, b, unlimited);
}

}  // namespace waymark::automata
