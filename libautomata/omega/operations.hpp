// Boolean operations on ω-automata of any acceptance: intersection, union, difference.
//
// Both automata read the same word, and propositions are matched by name. The conditions are combined over disjoint
// marks, without degeneralisation. Negation of a deterministic, complete automaton negates its condition; negation of
// other automata is not offered. [BK08, Sec. 4.4.2], conditions as in HOA.
#pragma once
#include <optional>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

// The alphabet of an automaton with other edges, whose variables are those of its own: never those of another
// automaton, which may read fewer propositions.
Automaton with_edges(const Automaton& automaton, const TransitionRelation& edges);

// An automaton of which every choice was seen to have at most one branch.
class Deterministic {
 public:
  static std::optional<Deterministic> checked(Automaton automaton);  // nothing when a letter has two branches somewhere
  const Automaton& automaton() const { return automaton_; }          // as it was checked

 private:
  explicit Deterministic(Automaton automaton) : automaton_(std::move(automaton)) {}
  Automaton automaton_;
};

// Throws what the budget throws: a state for every pair, and more than 64 sets count as too many.
Automaton intersection(const Automaton& a, const Automaton& b, Budget& budget);
// A new initial state that may start as either; two marks say which one the run is in. One pass. Throws
// std::length_error when more than 64 sets are needed.
Automaton sum(const Automaton& a, const Automaton& b);
// The pairs of both, complete: deterministic again. By complement(complement(a) ∩ complement(b)).
Deterministic either(const Deterministic& a, const Deterministic& b, Budget& budget);
Deterministic complement(const Deterministic& a);  // complete; at most one state and one set more

// An automaton whose variables are positions in `from`, over the positions in `to`. Both ascend, and `to` has all that
// the automaton asks for.
TransitionRelation renamed(const TransitionRelation& automaton, const std::vector<ltl::Proposition>& from,
                           const std::vector<ltl::Proposition>& to);

}  // namespace waymark::automata
