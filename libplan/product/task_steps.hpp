// δ as one map drives it: the automaton's steps on the letters that the map can append.
//
// A map has a few hundred distinct letters and a formula reads a handful of propositions, so the letters fall into few
// classes that the automaton cannot tell apart. Classes are found once; a state's steps are computed when it is first
// visited, one diagram walk per class, and looked up from then on.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

class TaskSteps {  // not for two threads at once
 public:
  // Matches the propositions that the automaton reads with the map's by name; throws ltl::FormatError naming one that
  // the map lacks. Map and automaton must outlive the object. O(letters · |reads|).
  TaskSteps(const Map& map, const automata::Dfa& dfa);

  const Map& map() const { return *map_; }
  const automata::Dfa& dfa() const { return *dfa_; }
  std::size_t classes() const { return representatives_.size(); }

  automata::StateId next(automata::StateId q,
                         LetterId letter) {  // δ(q, letter), O(1) but for the first visit of q
    if (rows_[q.index] == not_visited) visit(q);
    return targets_[rows_[q.index] + class_[letter.index]];
  }

 private:
  static constexpr std::size_t not_visited = SIZE_MAX;
  void visit(automata::StateId q);

  const Map* map_;
  const automata::Dfa* dfa_;
  std::vector<std::uint32_t> class_;          // by LetterId
  std::vector<ltl::Letter> representatives_;  // by class, over the automaton's vocabulary
  std::vector<std::size_t> rows_;             // by state: where its steps begin in targets_
  std::vector<automata::StateId> targets_;
};

}  // namespace waymark::plan
