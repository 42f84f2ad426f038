// The accepting part of a limit-deterministic automaton while jumps are selected: deterministic Büchi automata side by
// side, one for each jump.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// States beside each other; diagrams over the same variables, one branch at most in a choice. The initial state says
// nothing.
struct AcceptingPart {
  TransitionRelation automaton;  // Büchi
  AcceptingPart() { automaton.acceptance = Acceptance::buchi(); }
  // Copies the states of a part; the number of its first one. O(size of the part).
  std::uint32_t add(const TransitionRelation& part);
};

// Every edge that no cycle of unmarked edges goes through is marked: a run that takes it for ever meets marks for ever.
// Then states with one signature are merged. The second component: by old state, the new one.
struct MergedAcceptingPart {
  AcceptingPart accepting_part;       // with fewer states
  std::vector<std::uint32_t> number;  // of an old state in the new part
};
MergedAcceptingPart merged(const AcceptingPart& accepting_part, Budget& budget);  // states of one language become one

// Few states that answer requests, each of which may be answered by any of several states. Two greedy choices, the
// better one stays: request by request, those with a single option first, the option that reaches the fewest states
// not yet reached; and again and again the state that answers the most open requests per state that it adds.
class Choosing {
 public:
  explicit Choosing(const AcceptingPart& accepting_part);
  using Requests = std::vector<std::vector<std::uint32_t>>;  // by request, the options
  // Options: not empty, best first among equals. Returns the chosen option of every request.
  std::vector<std::uint32_t> choose(const Requests& requests);

 private:
  struct Answers {
    std::vector<std::uint32_t> chosen;  // by request
    std::size_t states;                 // reached from them
  };
  Answers one_by_one(const Requests& requests);
  Answers by_most_answered(const Requests& requests);
  Answers none(const Requests& requests);  // forgets what is reached
  std::size_t count_reached() const;
  std::size_t added(std::uint32_t state) const;  // states reached from it and not yet
  void reach(std::uint32_t state);

  std::vector<std::vector<std::uint32_t>> successors_;
  std::vector<bool> reached_;
};

}  // namespace waymark::automata
