// Strongly connected components of a graph with vertices 0 … size() − 1 and successors(v), by [Tar72] with an explicit
// stack. In a transition graph, decision nodes are vertices, too.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace waymark::automata {

struct Components {
  std::vector<std::uint32_t> of;     // component of a vertex; successors have smaller or equal ones
  std::vector<std::uint32_t> order;  // vertices by component, ascending
  std::uint32_t count = 0;           // of components
};

template <class Graph>
Components components(const Graph& graph) {  // O(vertices + edges)
  using Index = std::uint32_t;
  constexpr std::uint32_t none = UINT32_MAX;
  struct Frame {
    Index vertex;
    std::uint32_t edge;
  };
  Components out{std::vector<std::uint32_t>(graph.size(), none), {}, 0};
  out.order.reserve(graph.size());
  std::vector<std::uint32_t> index(graph.size(), none), low(graph.size(), none);
  std::vector<Index> open;
  std::vector<Frame> calls;
  std::uint32_t visited = 0;
  const auto enter = [&](Index v) {
    index[v] = low[v] = visited++;
    open.push_back(v);
    calls.push_back({v, 0});
  };
  for (Index start = 0; start < graph.size(); ++start) {
    if (index[start] != none) continue;
    enter(start);
    while (!calls.empty()) {
      const Index v = calls.back().vertex;
      if (calls.back().edge < graph.successors(v).size()) {
        const Index w = graph.successors(v)[calls.back().edge++];
        if (index[w] == none) {
          enter(w);
        } else if (out.of[w] == none) {
          low[v] = std::min(low[v], index[w]);
        }
        continue;
      }
      calls.pop_back();
      if (!calls.empty()) low[calls.back().vertex] = std::min(low[calls.back().vertex], low[v]);
      if (low[v] != index[v]) continue;
      for (Index w = none; w != v;) {
        w = open.back();
        open.pop_back();
        out.of[w] = out.count;
        out.order.push_back(w);
      }
      ++out.count;
    }
  }
  return out;
}

}  // namespace waymark::automata
