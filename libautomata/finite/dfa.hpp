// Deterministic, complete finite automata with symbolic edges.
//
// 𝒜 = (Q, AP, δ, q₀, Q_acc). δ(q, ·) is one multi-terminal BDD over the propositions that the automaton reads; its
// terminals are states. Acceptance is on states (docs/conventions.md 5): a finite, non-empty word is accepted when its
// run ends in Q_acc, and the initial state rejects the empty word. A state stands for what progression leaves of the
// formula, up to language equivalence.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "libautomata/bdd/mtbdd.hpp"
#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

struct StateId {            // a state of an automaton
  std::uint32_t index = 0;  // its number, from 0
  friend auto operator<=>(const StateId&, const StateId&) = default;
};

class Dfa {
 public:
  // roots[q]: δ(q, ·), terminals are state indices; accepting[q]. diagram's variables are positions in `reads`.
  // Throws std::invalid_argument when a terminal is no state, sizes differ, or the initial state accepts.
  Dfa(ltl::Vocabulary vocabulary, std::vector<ltl::Proposition> reads, Mtbdd diagram, std::vector<Mtbdd::Node> roots,
      std::vector<bool> accepting, StateId initial);

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }            // of the formula (or file)
  const std::vector<ltl::Proposition>& reads() const { return reads_; }        // only these matter, in BDD order
  std::size_t states() const { return roots_.size(); }                         // with the traps
  StateId initial() const { return initial_; }                                 // where words begin; never accepting
  bool is_accepting(StateId q) const { return accepting_[q.index]; }           // may a word end here?
  bool is_trap(StateId q) const { return distance_[q.index] == unreachable; }  // no accepting state reachable
  // Fewest letters from q to an accepting state, 0 when q accepts; `unreachable` for a trap.
  std::uint32_t distance_to_acceptance(StateId q) const { return distance_[q.index]; }
  static constexpr std::uint32_t unreachable = UINT32_MAX;

  StateId next(StateId q, const ltl::Letter& letter) const;  // δ(q, a), O(|reads|)

  // Other names for the same positions. Throws std::invalid_argument when one that is read has none.
  void rename(ltl::Vocabulary names);

  const Mtbdd& diagram() const { return diagram_; }              // where the edges are
  Mtbdd::Node root(StateId q) const { return roots_[q.index]; }  // δ(q, ·)

 private:
  ltl::Vocabulary vocabulary_;
  std::vector<ltl::Proposition> reads_;
  Mtbdd diagram_;
  std::vector<Mtbdd::Node> roots_;
  std::vector<bool> accepting_;
  std::vector<std::uint32_t> distance_;
  StateId initial_;
};

// Letters are over the vocabulary of the automaton.
bool accepts(const Dfa& dfa, const ltl::Trace& word);

}  // namespace waymark::automata
