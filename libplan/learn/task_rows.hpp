// A task as a learner meets it: automaton states and letters as small numbers, every step in one flat table.
//
// Letters are classes of letters of the model (alphabet_classes.hpp). Learners stop where a task ends: at acceptance
// (the prefix is good enough to stop there, conventions.md 4) and in traps.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libplan/product/alphabet_classes.hpp"

namespace waymark::plan {

enum class Ending : std::uint8_t { Open, Accepting, Trap };  // of an episode

struct TaskRows {
  static constexpr std::uint32_t unreachable = UINT32_MAX;  // no state

  AlphabetClasses classes;               // the letters of the task, over the automaton's vocabulary
  std::uint32_t tasks = 0, letters = 0;  // states; classes
  std::uint32_t initial = 0;             // before the first letter
  std::vector<std::uint32_t> next;       // by task · letters + letter
  std::vector<Ending> ending;            // by task
  std::vector<std::uint32_t> distance;   // by task: fewest letters to acceptance, or unreachable

  // The next state of the task.
  std::uint32_t after(std::uint32_t task, std::uint32_t letter) const { return next[task * letters + letter]; }
};

// Throws ltl::FormatError naming a proposition that the automaton reads and the model lacks.
TaskRows tabulate(const automata::Dfa& dfa, const Letters& letters);

}  // namespace waymark::plan
