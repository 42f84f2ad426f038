// Simulation between the states of an automaton, and what it allows to merge and to drop.
//
// q ≤ r: whatever letter is read, each branch (m, s) of q has a branch (m′, s′) of r with m ⊆ m′ and s ≤ s′. The
// greatest such relation is found by pairwise comparison of diagrams with early exit, repeated until nothing changes;
// no letter is listed. States that simulate each other are merged ([EWS05] has the proof for direct simulation), a
// branch goes when its choice has a better one ([EH00] "little brothers"). Reverse simulation is the same on
// reversed diagrams, the initial state related to itself only [SB00].
#pragma once
#include <vector>

#include "libautomata/effort.hpp"
#include "libautomata/omega/branching.hpp"

namespace waymark::automata {

// States with one signature merged: the coarsest partition that letters, marks and classes respect.
struct Quotient {
  Branching automaton;
  std::vector<std::uint32_t> number;  // of an old state in the new automaton
};
Quotient bisimulation(const Branching& automaton, Effort& effort);
inline Branching bisimulation_quotient(const Branching& automaton, Effort& effort) {
  return bisimulation(automaton, effort).automaton;
}

// Marks are read as "the more the better": generalised Büchi (or any condition without Fin).
Branching simulation_quotient(const Branching& automaton, Effort& effort);

// [q][r]: r simulates q, marks read as above.
std::vector<std::vector<bool>> direct_simulation(const Branching& automaton, Effort& effort);

// colour[q]: states of different colours are not merged (those with and without mark, where marks belong to states).
Branching reverse_simulation_quotient(const Branching& automaton, const std::vector<bool>& colour,
                                      Effort& effort);

}  // namespace waymark::automata
