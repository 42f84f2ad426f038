// What an automaton does on each kind of letter: letters on which every state has the same choice are one kind.
//
// Kinds can be as many as letters, so the table is made only where they are few. It is meant for relations between
// states that look at all pairs again and again: a row is an array, where two diagrams would be walked together.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct AlphabetClasses {
  std::size_t states = 0, kinds = 0;
  std::vector<std::uint32_t> choice;  // [q · kinds + kind], an id of `choices`
  Choices choices;

  std::span<const std::uint32_t> row(std::size_t q) const { return {choice.data() + q * kinds, kinds}; }
};

// nullopt when the diagrams have more than `most` paths together.
std::optional<AlphabetClasses> alphabet_classes(const TransitionRelation& automaton, std::size_t most,
                                                Budget& budget);
// δ⁻¹ on the same kinds: the branches of q are (marks, p) for the branches (marks, q) of p.
AlphabetClasses reversed(const AlphabetClasses& table, Budget& budget);

}  // namespace waymark::automata
