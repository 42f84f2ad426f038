#include "libautomata/hoa/written_graph.hpp"

#include <set>

#include "libautomata/graph/scc.hpp"

namespace waymark::automata {
namespace {

struct Graph {
  std::vector<std::vector<std::uint32_t>> lists;
  std::size_t size() const { return lists.size(); }
  const std::vector<std::uint32_t>& successors(std::uint32_t v) const { return lists[v]; }
};

}  // namespace

HoaGraph::HoaGraph(const HoaAutomaton& automaton) {
  find_components(automaton);
  describe(automaton);
}

void HoaGraph::find_components(const HoaAutomaton& automaton) {
  std::unordered_map<std::uint64_t, std::uint32_t> vertex;
  std::vector<std::uint64_t> numbers;
  Graph graph;
  const auto vertex_of = [&](std::uint64_t number) {
    const auto [at, fresh] = vertex.try_emplace(number, static_cast<std::uint32_t>(numbers.size()));
    if (fresh) {
      numbers.push_back(number);
      graph.lists.emplace_back();
    }
    return at->second;
  };
  for (const auto& start : automaton.starts)
    for (std::uint64_t number : start) vertex_of(number);
  for (const HoaAutomaton::State& state : automaton.states) {
    const std::uint32_t v = vertex_of(state.number);
    for (const HoaAutomaton::Edge& edge : state.edges) {
      if (edge.label == Boolean::constant(false)) continue;
      for (std::uint64_t target : edge.targets) {
        const std::uint32_t w = vertex_of(target);
        graph.lists[v].push_back(w);
      }
    }
  }
  const Components found = automata::components(graph);
  components_.resize(found.count);
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    of_.emplace(numbers[v], found.of[v]);
    components_[found.of[v]].states.push_back(numbers[v]);
  }
}

void HoaGraph::describe(const HoaAutomaton& automaton) {
  std::vector<std::set<std::uint64_t>> inside(components_.size());
  for (const HoaAutomaton::State& state : automaton.states) {
    const std::uint32_t c = of_.at(state.number);
    Component& component = components_[c];
    for (const HoaAutomaton::Edge& edge : state.edges) {
      if (edge.label == Boolean::constant(false)) continue;
      std::set<std::uint64_t> marks(state.marks.begin(), state.marks.end());
      marks.insert(edge.marks.begin(), edge.marks.end());
      for (std::uint64_t target : edge.targets) {
        if (of_.at(target) != c) {
          component.successors.push_back(of_.at(target));
          continue;
        }
        component.uniform = component.uniform && (!component.cyclic || inside[c] == marks);
        component.cyclic = true;
        inside[c] = marks;
      }
    }
    for (std::uint64_t mark : inside[c])
      if (mark < 64) component.marks |= std::uint64_t{1} << mark;
  }
}

}  // namespace waymark::automata
