// Deterministic parity automata, and reductions that keep their language.
//
// The internal condition is parity(Min, Even, n): the least colour that occurs infinitely often decides, and an even
// colour accepts. A branch has at most one mark, its colour. A branch without a mark has the colour n.
#pragma once
#include <optional>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libautomata/omega/reduce.hpp"

namespace waymark::automata {

// An automaton that was seen to be deterministic, with a parity condition (all, Büchi and co-Büchi are instances) and
// at most one mark on a branch. Letters without a branch reject.
class Dpa {
 public:
  // Nothing when the automaton is not deterministic, or its condition is no parity.
  static std::optional<Dpa> checked(Automaton automaton);
  const Automaton& automaton() const { return automaton_; }  // as it was checked

 private:
  explicit Dpa(Automaton automaton) : automaton_(std::move(automaton)) {}
  Automaton automaton_;
};

// Any of the four parity conditions as parity(Min, Even, n), the same language.
TransitionRelation min_even_parity(const TransitionRelation& automaton);

// The functions below take and give deterministic automata with parity(Min, Even, n).

// Up to so many states, languages of states are compared pair by pair, unless someone says that it is worth more.
constexpr std::size_t compared_states = 120;

// Languages of the states: no deterministic automaton of the same language has fewer live states, whatever its
// condition. Trimmed in; one step of budget per pair of nodes.
std::size_t count_languages(const TransitionRelation& automaton, Budget& budget);

// Trimmed; as few colours as the components need [CM99, Sec. 4]; states with one signature merged, and those of one
// language where fewer_states.hpp finds colours. When every component accepts or rejects as a whole the language is an
// obligation, and the result is the minimal automaton [Loe01]. Never throws Budget::Exceeded except when stopped: what
// was reached is returned.
Reduced reduce_parity(const TransitionRelation& automaton, Budget& budget, std::size_t compared = compared_states);

// The words that it rejects. Complete, one state more at most.
TransitionRelation complement_parity(const TransitionRelation& automaton);

// The same automaton with the plainest name: colours from 1 on are counted from 0, odd ones accepting.
TransitionRelation plain_parity(const TransitionRelation& automaton);

// Pair i: the colours below 2i finitely often, 2i infinitely often.
TransitionRelation as_rabin(const TransitionRelation& automaton);

}  // namespace waymark::automata
