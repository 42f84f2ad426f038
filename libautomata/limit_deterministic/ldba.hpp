// Limit-deterministic Büchi automata whose nondeterminism is sound for Markov decision processes.
//
// Such an automaton has an initial part and an accepting part, both deterministic; only the accepting part has marks. A
// state of the initial part offers jumps to states of the accepting part. A jump costs nothing, reads no letter, and
// asserts what holds for ever. A run with a wrong jump is rejected. The automaton is sound when, in its product with
// any MDP, the best strategy wins with the probability of the formula. Soundness is a theorem about a construction
// [SEJK16] and cannot be read off an automaton, so only our constructions make an MdpSafe.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

// The same while it is being built.
struct LimitDeterministic {
  TransitionRelation automaton;                   // one branch at most in a choice; Büchi
  std::vector<std::vector<std::uint32_t>> jumps;  // by state; none from states of the accepting part
  std::vector<bool> accepting_part;               // by state; its successors are in it too
};

// Reachable states from which some word is accepted, numbered breadth first, jumps after branches.
LimitDeterministic canonical(const LimitDeterministic& ldba);

// Jumps become branches: what a target offers on a letter is offered where the jump starts. Same numbering.
TransitionRelation without_jumps(const LimitDeterministic& ldba, Budget& budget);

class MdpSafe {  // made by our own translation only
 public:
  struct Transition {  // one step of a run
    StateId target;    // where it leads
    bool accepting;    // the edge is marked
  };

  const ltl::Vocabulary& vocabulary() const { return branches_.vocabulary(); }      // of the formula
  const std::vector<ltl::Proposition>& reads() const { return branches_.reads(); }  // only these matter
  std::size_t states() const { return branches_.states(); }                         // of both parts
  StateId initial() const { return branches_.initial(); }                           // in the initial part
  bool in_accepting_part(StateId q) const { return accepting_part_[q.index]; }      // after a jump
  bool is_deterministic() const;                                                    // nothing to jump

  // Where a run may go before it reads the next letter, in a fixed order: the index names the jump.
  std::span<const StateId> jumps(StateId q) const { return jumps_[q.index]; }
  // The step on a letter; none: the run is rejected. O(|reads|).
  std::optional<Transition> next(StateId q, const ltl::Letter& letter) const;

  // Other names for the same positions. Throws std::invalid_argument when one that is read has none.
  void rename(ltl::Vocabulary names) { branches_.rename(std::move(names)); }

  // A nondeterministic Büchi automaton of the same language and numbering, a branch for every jump.
  const Automaton& automaton() const { return branches_; }
  // What a run does between two jumps: deterministic, same numbering.
  const TransitionRelation& steps() const { return steps_; }

 private:
  friend class ProvedConstructions;  // ltl_to_ldba.cpp
  // Reads every proposition that is given: reads[v] is that of variable v.
  MdpSafe(LimitDeterministic ldba, const ltl::Vocabulary& vocabulary, std::vector<ltl::Proposition> reads);

  Automaton branches_;
  TransitionRelation steps_;  // without the jumps
  std::vector<std::vector<StateId>> jumps_;
  std::vector<bool> accepting_part_;
};

}  // namespace waymark::automata
