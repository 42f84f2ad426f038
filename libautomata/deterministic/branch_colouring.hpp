// Colours for the branches of a structure, from its product with a deterministic parity automaton (fewer_states.hpp).
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/graph/scc.hpp"

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
  BranchColouring(std::uint32_t branches, std::uint32_t sets) : branches_(branches), sets_(sets) {}

  // Colours with which a word is accepted by its branches as it is by its edges, as few as can be; nullopt: there are
  // none, and the edges that are left have none by themselves. Edges with a colour are taken out. Sources ascend.
  // O(sets · colours · edges).
  std::optional<Colours> colours(std::vector<ProductEdge>& edges, Budget& budget);

 private:
  void look_for_cycles(const std::vector<ProductEdge>& edges, std::uint32_t parity, Budget& budget);

  std::uint32_t branches_, sets_;
  // By branch: 1 when one of its edges is on a cycle whose least colour has the parity that was looked for.
  std::vector<std::uint32_t> blocked_;
  // What the searches for cycles take, kept from one to the next.
  std::vector<std::uint32_t> begin_, has_least_;
  Components found_;
  ComponentSearch search_;
};

}  // namespace waymark::automata
