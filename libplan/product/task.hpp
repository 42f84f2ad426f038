// The concept of a task: an automaton with numbered states, and its steps on the letters of one model.
//
// TaskTable is a DFA or an MdpSafe, tabulated; TaskSteps is a DFA whose steps are looked up when they are first taken;
// BuchiTask is a generalised Büchi automaton, whose steps are choices.
#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "libplan/world/letters.hpp"

namespace waymark::plan {

template <class T>
concept Task = requires(const T& task, std::uint32_t q, LetterId letter) {
  { task.states() } -> std::convertible_to<std::size_t>;
  { task.initial_states()[0] } -> std::convertible_to<std::uint32_t>;  // before the first letter, jumps taken
  { task.is_goal(q) } -> std::same_as<bool>;
  { task.is_over(q) } -> std::same_as<bool>;  // nothing is asked after it: its pairs have no choices
  { task.steps(q, letter).size() } -> std::convertible_to<std::size_t>;  // none: the task cannot be met any more
  { task.steps(q, letter)[0].target } -> std::convertible_to<std::uint32_t>;
  { task.jumps(q).size() } -> std::convertible_to<std::size_t>;
  { task.jumps(q)[0] } -> std::convertible_to<std::uint32_t>;
};

template <class Successor>
struct AtMostOne {   // the steps of a deterministic automaton
  Successor step;    // the step
  bool some = true;  // is there one?
  std::size_t size() const { return some ? 1 : 0; }
  const Successor& operator[](std::size_t) const { return step; }
  const Successor* begin() const { return &step; }
  const Successor* end() const { return &step + size(); }
};

}  // namespace waymark::plan
