#include "libautomata/hoa_graph.hpp"

#include <algorithm>
#include <set>

namespace waymark::automata {
namespace {

// [Tar72] over a list of successors, with an explicit stack. Components are numbered successors first.
class Tarjan {
 public:
  explicit Tarjan(const std::vector<std::vector<std::uint32_t>>& successors)
      : successors_(successors),
        index_(successors.size(), 0),
        low_(successors.size(), 0),
        component_(successors.size(), open) {
    for (std::uint32_t v = 0; v < successors.size(); ++v)
      if (index_[v] == 0) search(v);
  }
  const std::vector<std::uint32_t>& component() const { return component_; }
  std::uint32_t count() const { return count_; }

 private:
  static constexpr std::uint32_t open = UINT32_MAX;
  struct Frame {
    std::uint32_t vertex;
    std::size_t next;
  };

  void enter(std::uint32_t v) {
    index_[v] = low_[v] = ++visited_;
    path_.push_back(v);
    frames_.push_back({v, 0});
  }

  void search(std::uint32_t root) {
    enter(root);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const std::uint32_t v = frame.vertex;
      if (frame.next < successors_[v].size()) {
        const std::uint32_t w = successors_[v][frame.next++];
        if (index_[w] == 0)
          enter(w);
        else if (component_[w] == open)
          low_[v] = std::min(low_[v], index_[w]);
      } else {
        leave(v);
      }
    }
  }

  void leave(std::uint32_t v) {
    frames_.pop_back();
    if (!frames_.empty()) {
      std::uint32_t& above = low_[frames_.back().vertex];
      above = std::min(above, low_[v]);
    }
    if (low_[v] != index_[v]) return;
    for (std::uint32_t w = open; w != v;) {
      w = path_.back();
      path_.pop_back();
      component_[w] = count_;
    }
    ++count_;
  }

  const std::vector<std::vector<std::uint32_t>>& successors_;
  std::vector<std::uint32_t> index_, low_, component_, path_;
  std::vector<Frame> frames_;
  std::uint32_t visited_ = 0, count_ = 0;
};

}  // namespace

HoaGraph::HoaGraph(const HoaAutomaton& automaton) {
  find_components(automaton);
  describe(automaton);
}

void HoaGraph::find_components(const HoaAutomaton& automaton) {
  std::unordered_map<std::uint64_t, std::uint32_t> vertex;
  std::vector<std::uint64_t> numbers;
  std::vector<std::vector<std::uint32_t>> successors;
  const auto vertex_of = [&](std::uint64_t number) {
    const auto [at, fresh] = vertex.try_emplace(number, static_cast<std::uint32_t>(numbers.size()));
    if (fresh) {
      numbers.push_back(number);
      successors.emplace_back();
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
        successors[v].push_back(w);
      }
    }
  }
  const Tarjan tarjan(successors);
  components_.resize(tarjan.count());
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    of_.emplace(numbers[v], tarjan.component()[v]);
    components_[tarjan.component()[v]].states.push_back(numbers[v]);
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
