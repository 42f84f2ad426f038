// The greatest direct simulation between the states of an automaton, forward and backward.
//
// q ≤ r when, for every letter, each branch (m, s) of q has a branch (m′, s′) of r with m ⊆ m′ and s ≤ s′. The
// computation starts from all pairs and removes refuted pairs until a fixed point. With few alphabet classes, a pair is
// compared class by class. Otherwise some letters refute what they can, and diagrams are compared pairwise with early
// exit. The backward simulation is the same relation on reversed transitions, with the initial state related to itself
// only [SB00].
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

class StatePairs {  // a relation between the states of one automaton
 public:
  StatePairs(std::size_t states, bool all) : states_(states), holds_(states * states, all ? 1 : 0) {}
  bool operator()(std::uint32_t q, std::uint32_t r) const { return holds_[q * states_ + r] != 0; }
  void remove(std::uint32_t q, std::uint32_t r) { holds_[q * states_ + r] = 0; }  // q ≤ r is refuted
  std::size_t states() const { return states_; }                                  // of the automaton
  friend bool operator==(const StatePairs&, const StatePairs&) = default;

 private:
  std::size_t states_;
  std::vector<std::uint8_t> holds_;
};

// How pairs are compared; ByKinds only where the kinds are few. For tests: the relation is the same.
enum class Comparison : std::uint8_t { Cheapest, OfDiagrams };

StatePairs greatest_simulation(const TransitionRelation& automaton, Budget& budget,
                               Comparison how = Comparison::Cheapest);
// The same for runs that lead to a state.
StatePairs greatest_reverse_simulation(const TransitionRelation& automaton, Budget& budget,
                                       Comparison how = Comparison::Cheapest);

}  // namespace waymark::automata
