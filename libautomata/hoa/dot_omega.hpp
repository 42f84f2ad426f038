// Graphviz DOT of an ω-automaton. Each pair of states has one arrow, each set of marks one line of its label. Guards
// are short Unicode formulas, and every mark is a dot in its own colour.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libautomata/omega/automaton.hpp"

namespace waymark::automata {

struct OmegaDotOptions {  // how an ω-automaton is drawn
  std::string name = {};  // caption under the drawing, none when empty; the acceptance stands behind it
  std::vector<std::pair<std::uint32_t, std::uint32_t>> jumps = {};  // from, to: dotted arrows without a letter
};

// nullopt when there are more edges, or a guard has more cubes, than that.
std::optional<std::string> write_dot_within(const Automaton& automaton, std::size_t most_edges,
                                            const OmegaDotOptions& options = {});

}  // namespace waymark::automata
