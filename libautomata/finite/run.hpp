// The run of a DFA on a trajectory.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "libautomata/finite/dfa.hpp"

namespace waymark::automata {

struct Run {
  std::vector<StateId> states;         // q₀ first: one more than letters
  bool accepted = false;               // the last state accepts
  std::optional<std::size_t> trapped;  // letters read when hope ended, if it did: no continuation is accepted
};
Run run(const Dfa& dfa, const ltl::Trace& word);  // O(|word| · |reads|)

// A shortest accepted word, every proposition that does not matter being false; nullopt when the language is empty.
std::optional<ltl::Trace> shortest_word(const Dfa& dfa);

}  // namespace waymark::automata
