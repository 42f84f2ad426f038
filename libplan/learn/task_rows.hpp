// A task as a learner meets it: automaton states and letters as small numbers, every step in one flat table.
//
// A model has many letters and an automaton reads a handful of propositions, so the letters fall into few classes; a
// class may also carry a toss of coins that is not the model's (gltl.hpp), hence the list of classes for each letter.
// Learners stop where a task ends: at acceptance (the prefix is good enough to stop there, conventions.md 4) and in traps.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libplan/world/letters.hpp"

namespace waymark::plan {

enum class Ending : std::uint8_t { Open, Accepting, Trap };

struct TaskRows {
  static constexpr std::uint32_t unreachable = UINT32_MAX;
  struct Reading {  // how a letter of the model is read
    std::uint32_t letter = 0;
    double probability = 1;
  };

  std::uint32_t tasks = 0, letters = 0;        // states; classes of letters
  std::uint32_t initial = 0;                   // before the first letter
  std::vector<std::uint32_t> next;             // by task · letters + letter
  std::vector<Ending> ending;                  // by task
  std::vector<std::uint32_t> distance;         // by task: fewest letters to acceptance, or unreachable
  std::vector<std::vector<Reading>> readings;  // by LetterId of the model
  ltl::Vocabulary vocabulary;                  // of the task
  std::vector<ltl::Letter> carried;            // by letter: its propositions, over `vocabulary`

  std::uint32_t after(std::uint32_t task, std::uint32_t letter) const {
    return next[task * letters + letter];
  }
};

// The projection of the model's letters to a task's vocabulary, matched by name: classes in order of first occurrence.
// Throws ltl::FormatError naming a proposition of `reads` that the model lacks.
struct LetterProjection {
  LetterProjection(const Letters& letters, const ltl::Vocabulary& task,
                   const std::vector<ltl::Proposition>& reads);
  std::vector<std::uint32_t> of;     // by LetterId
  std::vector<ltl::Letter> carried;  // by class
};

TaskRows tabulate(const automata::Dfa& dfa, const Letters& letters);

}  // namespace waymark::plan
