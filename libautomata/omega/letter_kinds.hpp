// What an automaton does on each kind of letter: letters on which every state has the same choice are one kind.
//
// Kinds can be as many as letters, so the table is made only where they are few. It is meant for relations between
// states that look at all pairs again and again: a row is an array, where two diagrams would be walked together.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libautomata/omega/branching.hpp"

namespace waymark::automata {

struct LetterKinds {
  std::size_t states = 0, kinds = 0;
  std::vector<std::uint32_t> choice;  // [q · kinds + kind], an id of `choices`
  Choices choices;

  std::span<const std::uint32_t> row(std::size_t q) const { return {choice.data() + q * kinds, kinds}; }
};

// nullopt when the diagrams have more than `most` paths together.
std::optional<LetterKinds> letter_kinds(const Branching& automaton, std::size_t most, Effort& effort);
// δ⁻¹ on the same kinds: the branches of q are (marks, p) for the branches (marks, q) of p.
LetterKinds reversed(const LetterKinds& table, Effort& effort);

}  // namespace waymark::automata
