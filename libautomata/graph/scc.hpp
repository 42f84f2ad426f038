// Strongly connected components of a graph with vertices 0 … size() − 1 and successors(v), by [Tar72] with an explicit
// stack. In a transition graph, decision nodes are vertices, too.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace waymark::automata {

struct Components {                  // the components of a graph
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
      const auto& next = graph.successors(v);
      Index child = none, lowest = low[v];
      std::uint32_t edge = calls.back().edge;
      while (edge < next.size() && child == none) {
        const Index w = next[edge++];
        if (index[w] == none)
          child = w;
        else if (out.of[w] == none)
          lowest = std::min(lowest, index[w]);
      }
      low[v] = lowest;
      if (child != none) {
        calls.back().edge = edge;
        enter(child);
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
