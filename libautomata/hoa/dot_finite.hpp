// Graphviz DOT of a DFA. Edges are grouped by target, guards are short Unicode formulas, accepting states have double
// circles, and the layout runs from left to right.
#pragma once
#include <cstdint>
#include <string>

#include "libautomata/finite/dfa.hpp"

namespace waymark::automata {

struct DotOptions {
  enum class Trap : std::uint8_t { Grey, Omit };  // how states without hope are drawn
  Trap trap = Trap::Grey;                         // states without hope, and the edges to them
  std::string name = {};                          // caption under the drawing, none when empty
  std::size_t label_width = 36;                   // characters after which a guard breaks before ∨ or ∧
};

std::string write_dot(const Dfa& dfa, const DotOptions& options = {});  // the text of a graph

}  // namespace waymark::automata
