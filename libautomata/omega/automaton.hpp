// Nondeterministic automata on infinite words with symbolic, transition-based acceptance.
//
// 𝒜 = (Q, AP, δ, q₀, Acc). δ(q, ·) is one MTBDD over the propositions that the automaton reads. Its terminals are
// choices, sets of branches (marks, target). A run on a₀a₁… takes a branch of δ(qᵢ, aᵢ) at each step, and accepts when
// the marks that occur infinitely often satisfy Acc. A state may have no branch on a letter. Determinism is a property
// (is_deterministic); algorithms that need determinism take a type that was checked.
#pragma once
#include <span>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/omega/transition_relation.hpp"
#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

class Automaton {
 public:
  // The diagram's variables are positions in `reads`. Throws std::invalid_argument when a branch leads to no state or
  // carries a mark that the acceptance does not have, or a variable is not read.
  Automaton(ltl::Vocabulary vocabulary, std::vector<ltl::Proposition> reads, TransitionRelation transitions);

  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }         // of the formula
  const std::vector<ltl::Proposition>& reads() const { return reads_; }     // only these matter, in BDD order
  std::size_t states() const { return transitions_.states(); }              // trimmed, as a rule
  StateId initial() const { return StateId{transitions_.initial}; }         // where words begin
  const Acceptance& acceptance() const { return transitions_.acceptance; }  // over the marks of the branches

  std::span<const Branch> next(StateId q, const ltl::Letter& letter) const;  // δ(q, a), O(|reads|)

  // Other names for the same positions. Throws std::invalid_argument when one that is read has none.
  void rename(ltl::Vocabulary names);

  const TransitionRelation& transitions() const { return transitions_; }     // the edges and the condition
  const Mtbdd& diagram() const { return transitions_.diagram; }              // where the edges are
  Mtbdd::Node root(StateId q) const { return transitions_.roots[q.index]; }  // δ(q, ·)

 private:
  ltl::Vocabulary vocabulary_;
  std::vector<ltl::Proposition> reads_;
  TransitionRelation transitions_;
};

// Renames the variables so that only those stay which some edge asks for; their propositions. reads[v]: that of v.
std::vector<ltl::Proposition> keep_asked(TransitionRelation& transitions, const std::vector<ltl::Proposition>& reads);

// The same automaton in canonical numbering, reading only the propositions that an edge asks for.
// reads[v]: the proposition of variable v.
Automaton as_automaton(const TransitionRelation& transitions, const ltl::Vocabulary& vocabulary,
                       const std::vector<ltl::Proposition>& reads);

}  // namespace waymark::automata
