// Merging of states and pruning of branches by simulation.
//
// States that simulate each other are merged ([EWS05] has the proof for direct simulation). A branch is removed when
// its choice has a better one ([EH00] "little brothers"). Backward simulation allows the same. Both together prune more
// than either [MC13]. greatest_simulation.hpp computes the relations.
#pragma once
#include <memory>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// States with one signature merged: the coarsest partition that letters, marks and classes respect.
struct Quotient {
  TransitionRelation automaton;       // of the classes
  std::vector<std::uint32_t> number;  // of an old state in the new automaton
};
Quotient bisimulation(const TransitionRelation& automaton, Budget& budget);
// Without the numbers.
inline TransitionRelation bisimulation_quotient(const TransitionRelation& automaton, Budget& budget) {
  return bisimulation(automaton, budget).automaton;
}

// The states that have a branch with a mark.
std::vector<bool> marked_states(const TransitionRelation& automaton);

// Each state and its representative one, with the branches of all of them. A representative stands for itself.
TransitionRelation united(const TransitionRelation& automaton, const std::vector<std::uint32_t>& representative,
                          Budget& budget);

// Marks are read as "the more the better": generalised Büchi (or any condition without Fin).
// [q][r]: r simulates q.
std::vector<std::vector<bool>> direct_simulation(const TransitionRelation& automaton, Budget& budget);

// What the simulations of one automaton allow. A relation is found when it is first needed, and once.
class Simulations {
 public:
  Simulations(const TransitionRelation& automaton, Budget& budget);  // both must stay
  ~Simulations();
  // States that simulate each other merged; where there are none, branches pruned.
  TransitionRelation quotient();
  // The same backwards. colour[q]: states of different colours are not merged (those with and without mark, where marks
  // belong to states).
  TransitionRelation reverse_quotient(const std::vector<bool>& colour);
  // Branches (m, s) of p dropped, letter by letter, when a state p′ that is strictly above p in reverse simulation has
  // a branch (m′, s′) with m ⊆ m′ and s ≤ s′: whatever run comes to p and goes on by the one, another comes to p′ and
  // goes on by the other. All at once: put right from left to right, a run only ever climbs in reverse simulation at
  // the leftmost position that changes, so each beginning is put right after finitely many steps.
  TransitionRelation without_overtaken();

 private:
  struct Relations;
  const Relations& with_forwards();
  const Relations& with_backwards();

  const TransitionRelation& automaton_;
  Budget& budget_;
  std::unique_ptr<Relations> relations_;
};

}  // namespace waymark::automata
