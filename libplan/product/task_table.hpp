// The task as one model drives it: the steps of an automaton on the letters that the model can append, flat.
//
// Letters that the automaton cannot tell apart form one class. States are renumbered so that strongly connected
// components stand together and none leads to a higher one: solvers take them in ascending order. States from which
// nothing is accepted are no states here, a step into one leads to `trap`. Propositions that the model does not know
// never hold.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/limit_deterministic/ldba.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/product/task.hpp"

namespace waymark::plan {

class TaskTable {
 public:
  static constexpr std::uint32_t trap = UINT32_MAX >> 1U;  // no state is accepting from there on
  struct Successor {                                       // where a letter leads
    std::uint32_t target;                                  // or trap
    bool marked;                                           // an accepting edge of a Büchi automaton
  };

  // A finite task: states that accept are goals, nothing is asked after them. O(states · classes · |reads|).
  TaskTable(const automata::Dfa& dfa, const Letters& letters);
  // The opposite, that it is never accepted: traps are the goals, accepting states lead nowhere, edges are marked.
  static TaskTable never(const automata::Dfa& dfa, const Letters& letters);
  // An infinite task: edges are marked, and a run may jump.
  TaskTable(const automata::MdpSafe& automaton, const Letters& letters);

  // In this numbering, the trap left out.
  std::uint32_t states() const { return static_cast<std::uint32_t>(goal_.size()); }
  bool is_goal(std::uint32_t q) const { return goal_[q]; }            // may the word end here?
  bool has_marks() const { return has_marks_; }                       // is any edge marked?
  std::uint32_t origin(std::uint32_t q) const { return origin_[q]; }  // as the automaton numbers it
  Successor next(std::uint32_t q, LetterId letter) const {            // of the deterministic part
    const std::uint32_t step = steps_[std::size_t{q} * row_ + classes_.of(letter)];
    return {step & trap, (step & marked) != 0};
  }
  AtMostOne<Successor> steps(std::uint32_t q, LetterId letter) const {  // none into the trap
    const Successor step = next(q, letter);
    return {step, step.target != trap};
  }
  const std::vector<std::uint32_t>& initial_states() const { return initial_states_; }
  // What the concept of a task (task.hpp) asks.
  bool is_over(std::uint32_t q) const { return goal_[q]; }
  std::span<const std::uint32_t> jumps(std::uint32_t q) const { return list(jumps_, q); }
  // States with a step into q; states with a jump to q.
  std::span<const std::uint32_t> sources(std::uint32_t q) const { return list(sources_, q); }
  std::span<const std::uint32_t> jump_sources(std::uint32_t q) const { return list(jump_sources_, q); }
  // Components are [component(i), component(i + 1)); no step or jump leads to a higher one.
  const std::vector<std::uint32_t>& components() const { return components_; }

 private:
  static constexpr std::uint32_t marked = trap + 1;
  struct Lists {
    std::vector<std::uint32_t> first, values;
  };
  struct Unordered;  // the same before it is renumbered
  TaskTable(const automata::Dfa& dfa, const Letters& letters, bool never);
  static std::span<const std::uint32_t> list(const Lists& lists, std::uint32_t q) {
    return {lists.values.data() + lists.first[q], lists.values.data() + lists.first[q + 1]};
  }
  void adopt(const Unordered& unordered);
  static Lists lists_of(const std::vector<std::vector<std::uint32_t>>& rows);

  AlphabetClasses classes_;
  std::uint32_t row_;                          // classes
  std::vector<std::uint32_t> initial_states_;  // none when nothing is accepted
  std::vector<std::uint32_t> steps_;           // by state and class: target, and whether it is marked
  bool has_marks_ = false;
  std::vector<bool> goal_;
  std::vector<std::uint32_t> origin_;
  Lists jumps_, sources_, jump_sources_;
  std::vector<std::uint32_t> components_;
};

static_assert(Task<TaskTable>);

}  // namespace waymark::plan
