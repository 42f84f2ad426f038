#include "libautomata/omega/emptiness.hpp"

#include <utility>

namespace waymark::automata {
namespace {

// Does a run that stays among `states`, one component of the graph, satisfy the condition?
bool component_accepts(const BranchGraph& graph, const std::vector<std::uint32_t>& states,
                       const Condition& condition);

// Some component of the part of the graph that lies in `states` and carries none of the forbidden marks accepts.
bool part_accepts(const BranchGraph& graph, const std::vector<std::uint32_t>& states, Marks forbidden,
                  const Condition& condition) {
  std::vector<std::uint32_t> number(graph.size(), UINT32_MAX);
  for (std::uint32_t i = 0; i < states.size(); ++i) number[states[i]] = i;
  BranchGraph part;
  for (std::uint32_t i = 0; i < states.size(); ++i) part.add_state();
  for (std::uint32_t i = 0; i < states.size(); ++i)
    for (const Branch& b : graph.branches(states[i]))
      if (number[b.target] != UINT32_MAX && (b.marks & forbidden).empty())
        part.add(i, {number[b.target], b.marks});
  const Components found = components(part);
  for (std::size_t i = 0; i < found.order.size();) {
    std::vector<std::uint32_t> component;
    const std::uint32_t name = found.of[found.order[i]];
    for (; i < found.order.size() && found.of[found.order[i]] == name; ++i)
      component.push_back(found.order[i]);
    if (component_accepts(part, component, condition)) return true;
  }
  return false;
}

bool component_accepts(const BranchGraph& graph, const std::vector<std::uint32_t>& states,
                       const Condition& condition) {
  std::vector<bool> inside(graph.size(), false);
  for (std::uint32_t q : states) inside[q] = true;
  Marks met;
  bool has_edge = false;
  for (std::uint32_t q : states)
    for (const Branch& b : graph.branches(q)) {
      if (!inside[b.target]) continue;
      has_edge = true;
      met = met | b.marks;
    }
  if (!has_edge) return false;
  Condition rest = condition;
  for (std::uint32_t mark : condition.marks().without(met).members()) rest = rest.replaced(mark, false);
  if (rest.holds(met)) return true;
  const Marks fins = rest.fin_marks();
  if (fins.empty()) return false;
  const std::uint32_t mark = fins.members().front();
  return part_accepts(graph, states, Marks::of(mark), rest.replaced(mark, false)) ||
         component_accepts(graph, states, rest.without_fin(mark));
}

}  // namespace

BranchGraph::BranchGraph(const Branching& automaton) {
  ChoiceLists choices(automaton);
  for (std::uint32_t q = 0; q < automaton.states(); ++q) states_.push_back(choices.branches(q));
}

LiveComponents live_components(const BranchGraph& graph, const Condition& condition) {
  LiveComponents out{components(graph), {}, std::vector<bool>(graph.size(), false)};
  const std::vector<std::uint32_t>& order = out.components.order;
  for (std::size_t i = 0; i < order.size();) {  // successors first
    std::vector<std::uint32_t> states;
    const std::uint32_t name = out.components.of[order[i]];
    for (; i < order.size() && out.components.of[order[i]] == name; ++i) states.push_back(order[i]);
    const bool accepting = component_accepts(graph, states, condition);
    bool live = accepting;
    for (std::uint32_t q : states)
      for (const Branch& b : graph.branches(q)) live = live || out.live[b.target];
    for (std::uint32_t q : states) out.live[q] = live;
    out.accepting.push_back(accepting);
  }
  return out;
}

bool is_empty(const Branching& automaton) {
  return !live_components(BranchGraph(automaton), automaton.acceptance.condition).live[automaton.initial];
}

bool accepts(const Automaton& automaton, const ltl::Lasso& word) {
  const auto states = static_cast<std::uint32_t>(automaton.states());
  BranchGraph graph;  // vertex position · |Q| + q: about to read the letter at that position in state q
  for (std::size_t i = 0; i < word.size(); ++i)
    for (std::uint32_t q = 0; q < states; ++q) {
      graph.add_state();
      const auto source = static_cast<std::uint32_t>(graph.size() - 1);
      const auto after = static_cast<std::uint32_t>(word.successor(i)) * states;
      for (const Branch& b : automaton.next(StateId{q}, word[i]))
        graph.add(source, {after + b.target, b.marks});
    }
  return live_components(graph, automaton.acceptance().condition).live[automaton.initial().index];
}

}  // namespace waymark::automata
