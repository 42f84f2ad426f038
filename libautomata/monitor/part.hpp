// One automaton among several that read the same word: the states that its runs have reached, and its ways on.
//
// A place is a set of states, found as words lead to it: the subset construction, lazily. The automaton is trimmed, so
// the empty place is reached exactly when no continuation is accepted. A move is a path of the diagram of a place: what
// the path asks of the letter, and the branch that the run takes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/omega/automaton.hpp"
#include "libltl/word.hpp"

namespace waymark::automata {

class Part {
 public:
  using Place = std::uint32_t;         // a number
  static constexpr Place nowhere = 0;  // the empty set

  struct Literal {                 // of a letter
    ltl::Proposition proposition;  // that a move asks for
    bool value;                    // in the letter or not
  };
  struct Move {                 // a way on
    std::vector<Literal> cube;  // in the order of the diagram
    Place target;               // of one state
    Marks marks;                // of the branch
  };

  // Of a trimmed generalised Büchi automaton (or one without marks, all of whose runs accept).
  explicit Part(const Automaton& trimmed);
  // Of the finite words that a DFA accepts, or of the others; states that no such word leads on from are left out.
  Part(const Dfa& dfa, bool complement);

  Place initial() const { return initial_; }                             // of words that are not begun
  Place next(Place from, const ltl::Letter& letter);                     // O(states of the place × |reads|)
  bool is_accepting(Place place) const { return accepts_[place]; }       // finite words: the word may end here
  std::uint32_t sets() const { return relation_.acceptance.sets; }       // of marks
  const std::vector<ltl::Proposition>& reads() const { return reads_; }  // only these matter
  std::size_t places() const { return states_of_.size(); }               // found so far, with `nowhere`
  Place keep_only(Place place);                                          // forgets all others; its new number

  // The ways on, those that accept soonest first: along all marks, or to acceptance. nullopt beyond most_moves.
  const std::optional<std::vector<Move>>& moves(Place from);
  static constexpr std::size_t most_moves = 4096;

 private:
  Place place_of(std::vector<std::uint32_t> states);
  void find_distances();
  std::uint32_t distance_of(const Branch& branch) const;
  bool add_moves(std::uint32_t state, std::vector<Move>& out);

  TransitionRelation relation_;
  std::vector<ltl::Proposition> reads_;  // of the variables of its diagram
  std::vector<bool> is_final_;           // by state; empty over infinite words
  std::vector<std::uint32_t> distance_;  // by state, in branches: to all marks at once, or to a final state
  std::map<std::vector<std::uint32_t>, Place> number_;
  std::vector<std::vector<std::uint32_t>> states_of_;                   // by place
  std::vector<bool> accepts_;                                           // by place
  std::vector<std::optional<std::optional<std::vector<Move>>>> moves_;  // by place, where they were asked for
  Place initial_ = nowhere;
};

}  // namespace waymark::automata
