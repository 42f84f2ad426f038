// The alphabet classes of an automaton: two letters are in one class when every state has the same choice on both.
//
// Classes can be as many as letters, so the table is built only where there are few. Algorithms that compare all pairs
// of states again and again then read rows of an array instead of walking two diagrams.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct AlphabetClasses {
  std::size_t states = 0, kinds = 0;  // of the automaton; of its letters
  std::vector<std::uint32_t> choice;  // [q · kinds + kind], an id of `choices`
  Choices choices;                    // by id

  // The choices of q by class.
  std::span<const std::uint32_t> row(std::size_t q) const { return {choice.data() + q * kinds, kinds}; }
};

// nullopt when the diagrams have more than `most` paths together.
std::optional<AlphabetClasses> alphabet_classes(const TransitionRelation& automaton, std::size_t most, Budget& budget);
// δ⁻¹ on the same kinds: the branches of q are (marks, p) for the branches (marks, q) of p.
AlphabetClasses reversed(const AlphabetClasses& table, Budget& budget);

}  // namespace waymark::automata
