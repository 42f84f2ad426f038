// The syntax tree of a formula as a graph.
#pragma once
#include <string>

#include "libltl/formula.hpp"

namespace waymark::tools {

// Graphviz DOT. Operands stand from left to right; F and G, which are stored as U and R, are drawn as such. A
// subformula is drawn as often as it occurs. Throws GaveUp beyond most_drawn_states nodes.
std::string dot_of_tree(ltl::Formula formula);

}  // namespace waymark::tools
