#include "libautomata/scc.hpp"

#include <algorithm>

namespace waymark::automata {

Components components(const TransitionGraph& graph) {
  using Vertex = TransitionGraph::Vertex;
  constexpr std::uint32_t none = UINT32_MAX;
  struct Frame {
    Vertex vertex;
    std::uint32_t edge;
  };
  Components out{std::vector<std::uint32_t>(graph.size(), none), {}, 0};
  out.order.reserve(graph.size());
  std::vector<std::uint32_t> index(graph.size(), none), low(graph.size(), none);
  std::vector<Vertex> open;
  std::vector<Frame> calls;
  std::uint32_t visited = 0;
  const auto enter = [&](Vertex v) {
    index[v] = low[v] = visited++;
    open.push_back(v);
    calls.push_back({v, 0});
  };
  for (Vertex start = 0; start < graph.size(); ++start) {
    if (index[start] != none) continue;
    enter(start);
    while (!calls.empty()) {
      const Vertex v = calls.back().vertex;
      if (calls.back().edge < graph.successors(v).size()) {
        const Vertex w = graph.successors(v)[calls.back().edge++];
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
      for (Vertex w = none; w != v;) {
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
