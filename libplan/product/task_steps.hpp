// A DFA as one map drives it: steps on the letters that the map can append, computed when a state is first visited.
//
// Rows are kept: one diagram walk per class of letters (alphabet_classes.hpp) and state, then a look-up. Nothing is
// done for states that are never visited, of which large automata have many.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/product/task.hpp"
#include "libplan/world/map.hpp"

namespace waymark::plan {

class TaskSteps {  // not for two threads at once, though const: rows are kept
 public:
  struct Successor {       // where a letter leads
    std::uint32_t target;  // a state of the automaton
  };
  // Whether a step into a trap is one: products that are shown have traps, as states without choices.
  enum class Traps : std::uint8_t { Kept, LeftOut };

  // Throws ltl::FormatError naming a proposition that the map lacks. Map and automaton must outlive the object.
  TaskSteps(const Map& map, const automata::Dfa& dfa, Traps traps = Traps::Kept);

  const Map& map() const { return *map_; }                 // whose letters are read
  const automata::Dfa& dfa() const { return *dfa_; }       // whose steps they are
  std::size_t classes() const { return classes_.size(); }  // of letters

  automata::StateId next(automata::StateId q, LetterId letter) const {  // O(1) but for the first visit of q
    if (rows_[q.index] == not_visited) visit(q);
    return targets_[rows_[q.index] + classes_.of(letter)];
  }

  // What the concept of a task (task.hpp) asks.
  std::size_t states() const { return rows_.size(); }
  std::array<std::uint32_t, 1> initial_states() const { return {dfa_->initial().index}; }
  bool is_goal(std::uint32_t q) const { return dfa_->is_accepting(automata::StateId{q}); }
  bool is_over(std::uint32_t q) const { return dfa_->is_trap(automata::StateId{q}); }
  AtMostOne<Successor> steps(std::uint32_t q, LetterId letter) const {
    const automata::StateId target = next(automata::StateId{q}, letter);
    return {{target.index}, traps_ == Traps::Kept || !dfa_->is_trap(target)};
  }
  static std::span<const std::uint32_t> jumps(std::uint32_t) { return {}; }

 private:
  static constexpr std::size_t not_visited = SIZE_MAX;
  void visit(automata::StateId q) const;

  const Map* map_;
  const automata::Dfa* dfa_;
  Traps traps_;
  AlphabetClasses classes_;
  mutable std::vector<std::size_t> rows_;  // by state: where its steps begin in targets_
  mutable std::vector<automata::StateId> targets_;
};
static_assert(Task<TaskSteps>);

}  // namespace waymark::plan
