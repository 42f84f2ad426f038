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

// The search, and the room that it takes, which the next one takes again.
class ComponentSearch {
 public:
  template <class Graph>
  void run(const Graph& graph, Components& out) {  // O(vertices + edges)
    const auto size = static_cast<std::uint32_t>(graph.size());
    out.order.clear();
    out.order.reserve(size);
    out.count = 0;
    low_.assign(size, 0);
    open_.resize(size);
    calls_.resize(size);
    std::uint32_t opened = 0;  // vertices that were met and have no component yet: the index of the last one
    std::size_t depth = 0;
    const auto enter = [&](std::uint32_t v) {
      open_[opened] = v;
      low_[v] = ++opened;
      calls_[depth++] = {v, 0, opened};
    };
    for (std::uint32_t start = 0; start < size; ++start) {
      if (low_[start] != 0) continue;
      enter(start);
      while (depth > 0) {
        Frame& frame = calls_[depth - 1];
        const std::uint32_t v = frame.vertex;
        const auto& next = graph.successors(v);
        const auto degree = static_cast<std::uint32_t>(next.size());
        std::uint32_t lowest = low_[v], edge = frame.edge, child = size;
        while (edge < degree) {
          const std::uint32_t w = next[edge++], there = low_[w];
          if (there == 0) {
            child = w;
            break;
          }
          lowest = std::min(lowest, there);
        }
        low_[v] = lowest;
        if (child != size) {
          frame.edge = edge;
          enter(child);
          continue;
        }
        if (--depth > 0) {
          std::uint32_t& above = low_[calls_[depth - 1].vertex];
          above = std::min(above, lowest);
        }
        if (lowest != frame.index) continue;
        const std::uint32_t known = size - out.count++;  // no vertex that is open has a greater index
        for (std::uint32_t w = size; w != v;) {
          w = open_[--opened];
          low_[w] = known;
          out.order.push_back(w);
        }
      }
    }
    out.of.resize(size);
    for (std::uint32_t v = 0; v < size; ++v) out.of[v] = size - low_[v];
  }

 private:
  struct Frame {
    std::uint32_t vertex, edge, index;
  };
  // By vertex: the least index that it is known to lead to; size − component once that is known; 0: not met.
  std::vector<std::uint32_t> low_;
  std::vector<std::uint32_t> open_;  // a stack
  std::vector<Frame> calls_;         // a stack
};

template <class Graph>
Components components(const Graph& graph) {  // O(vertices + edges)
  Components out;
  ComponentSearch().run(graph, out);
  return out;
}

}  // namespace waymark::automata
