// The greatest direct simulation between the states of an automaton, forwards and backwards.
//
// q ≤ r: whatever letter is read, each branch (m, s) of q has a branch (m′, s′) of r with m ⊆ m′ and s ≤ s′. All pairs
// are taken to be in the relation until one is refuted, and those that are left are looked at again until nothing
// changes. Where letters are of few kinds, a pair is compared kind by kind; else diagrams are compared pairwise with
// early exit, after some letters refuted what they can. Reverse simulation is the same on reversed transitions, the
// initial state related to itself only [SB00].
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
  void remove(std::uint32_t q, std::uint32_t r) { holds_[q * states_ + r] = 0; }
  std::size_t states() const { return states_; }
  friend bool operator==(const StatePairs&, const StatePairs&) = default;

 private:
  std::size_t states_;
  std::vector<std::uint8_t> holds_;
};

// How pairs are compared; ByKinds only where the kinds are few. For tests: the relation is the same.
enum class Comparison : std::uint8_t { Cheapest, OfDiagrams };

StatePairs greatest_simulation(const TransitionRelation& automaton, Budget& budget,
                               Comparison how = Comparison::Cheapest);
StatePairs greatest_reverse_simulation(const TransitionRelation& automaton, Budget& budget,
                                       Comparison how = Comparison::Cheapest);

}  // namespace waymark::automata
