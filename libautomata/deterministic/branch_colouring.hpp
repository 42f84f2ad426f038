// Colours for the branches of a structure, from its product with a deterministic parity automaton (fewer_states.hpp).
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libautomata/budget.hpp"

namespace waymark::automata {

struct ProductEdge {             // of a product of the structure and the automaton
  std::uint32_t source, target;  // pairs
  std::uint32_t colour;          // in the automaton
  std::uint32_t branch;          // of the structure
};

class BranchColouring {
 public:
  using Colours = std::vector<std::uint32_t>;         // by branch; unset: of branches without an edge
  static constexpr std::uint32_t unset = UINT32_MAX;  // no colour

  // Of a structure with so many branches, and a min-even automaton with so many sets.
  BranchColouring(std::uint32_t branches, std::uint32_t sets, Budget& budget)
      : branches_(branches), sets_(sets), budget_(budget) {}

  // Colours with which a word is accepted by its branches as it is by its edges, as few as can be; nullopt: there are
  // none, and the edges that are left have none by themselves. Edges with a colour are taken out. Sources ascend.
  // O(sets · colours · edges).
  std::optional<Colours> colours(std::vector<ProductEdge>& edges) const;

 private:
  std::vector<std::uint32_t> on_cycles(const std::vector<ProductEdge>& edges, std::uint32_t parity) const;

  std::uint32_t branches_, sets_;
  Budget& budget_;
};

}  // namespace waymark::automata
