// The explicit edges of an ω-automaton, for output. Inside the library, edges are decision diagrams.
//
// There is one edge for each (source, marks, target), and its guard is the set of letters of that branch. Edges are
// counted before they are built, so the limit bounds the running time.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "libautomata/finite/guard.hpp"
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

// Distinct (source, marks, target); nullopt when there are more than that. Stops there.
std::optional<std::size_t> count_edges(const TransitionRelation& automaton, std::size_t most);

// The branches of states as Boolean diagrams over the propositions that are read.
class BranchLetters {
 public:
  explicit BranchLetters(const TransitionRelation& automaton);  // which must outlive it
  BranchLetters(const BranchLetters&) = delete;
  BranchLetters& operator=(const BranchLetters&) = delete;
  Mtbdd::Node letters(std::uint32_t source, const Branch& branch);  // on which q may take it
  Mtbdd& diagram() { return scratch_; }                             // of the letters
  Boolean& logic() { return logic_; }                               // over the same diagram

 private:
  const TransitionRelation& automaton_;
  Mtbdd scratch_;  // the automaton's diagram, and the Boolean ones
  Boolean logic_;
};

struct BranchEdge {  // an edge of the output
  Branch branch;     // target and marks
  Guard guard;       // the letters of the edge
};
// By source, then target, then marks. nullopt when there are more than that, or a guard has more cubes.
std::optional<std::vector<std::vector<BranchEdge>>> edges_by_state(const TransitionRelation& automaton,
                                                                   std::size_t most);

// The letter of a cube, propositions that do not matter being false.
ltl::Letter letter_of(const Cube& cube, const std::vector<ltl::Proposition>& reads);
// The guard as a formula over those propositions, in an arena that gains their names.
ltl::Formula to_formula(const Guard& guard, const Automaton& automaton, ltl::Arena& arena);
// Decision nodes that the automaton consists of.
std::size_t count_nodes(const Automaton& automaton);

}  // namespace waymark::automata
