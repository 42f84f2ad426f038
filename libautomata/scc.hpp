// Strongly connected components of a transition graph, decision nodes included. [Tar72], with an explicit stack.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/transitions.hpp"

namespace waymark::automata {

struct Components {
  std::vector<std::uint32_t> of;               // component of a vertex; successors have smaller or equal ones
  std::vector<TransitionGraph::Vertex> order;  // vertices by component, ascending
  std::uint32_t count = 0;
};
Components components(const TransitionGraph& graph);  // O(vertices)

}  // namespace waymark::automata
