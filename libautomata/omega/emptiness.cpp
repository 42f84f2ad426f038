#include "libautomata/omega/emptiness.hpp"

#include <algorithm>

namespace waymark::automata {
namespace {

using States = std::vector<std::uint32_t>;  // ascending: a component may be small in a large graph

bool has(const States& states, std::uint32_t q) { return std::binary_search(states.begin(), states.end(), q); }

// Does a run that stays among `states`, one component of the graph, satisfy the condition?
bool component_accepts(const BranchGraph& graph, const States& states, const Condition& condition);

// Some component of the part of the graph that lies in `states` and carries none of the forbidden marks accepts.
bool part_accepts(const BranchGraph& graph, const States& states, Marks forbidden, const Condition& condition) {
  BranchGraph part;
  for (std::uint32_t i = 0; i < states.size(); ++i) part.add_state();
  for (std::uint32_t i = 0; i < states.size(); ++i)
    for (const Branch& b : graph.branches(states[i])) {
      if (!has(states, b.target) || !(b.marks & forbidden).empty()) continue;
      const auto at = std::lower_bound(states.begin(), states.end(), b.target);
      part.add(i, {static_cast<std::uint32_t>(at - states.begin()), b.marks});
    }
  const Components found = components(part);
  for (std::size_t i = 0; i < found.order.size();) {
    States component;
    const std::uint32_t name = found.of[found.order[i]];
    for (; i < found.order.size() && found.of[found.order[i]] == name; ++i) component.push_back(found.order[i]);
    std::sort(component.begin(), component.end());
    if (component_accepts(part, component, condition)) return true;
  }
  return false;
}

bool component_accepts(const BranchGraph& graph, const States& states, const Condition& condition) {
  Marks met;
  bool has_edge = false;
  for (std::uint32_t q : states)
    for (const Branch& b : graph.branches(q)) {
      if (!has(states, b.target)) continue;
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

BranchGraph::BranchGraph(const TransitionRelation& automaton) {
  ChoiceLists choices(automaton);
  for (; states_ < automaton.states(); ++states_) {
    for (std::uint32_t c : choices.of(static_cast<std::uint32_t>(states_))) {
      const auto choice = automaton.choices[c];
      branches_.insert(branches_.end(), choice.begin(), choice.end());
    }
    const auto first = branches_.begin() + static_cast<std::ptrdiff_t>(begin_.back());
    std::sort(first, branches_.end());
    branches_.erase(std::unique(first, branches_.end()), branches_.end());
    begin_.push_back(branches_.size());
  }
}

void BranchGraph::add(std::uint32_t source, Branch branch) {
  while (begin_.size() < source + std::size_t{2}) begin_.push_back(branches_.size());
  branches_.insert(branches_.begin() + static_cast<std::ptrdiff_t>(begin_[source + 1]), branch);
  for (std::size_t q = source + 1; q < begin_.size(); ++q) ++begin_[q];
}

LiveComponents live_components(const BranchGraph& graph, const Condition& condition) {
  LiveComponents out{components(graph), {}, std::vector<bool>(graph.size(), false)};
  const std::vector<std::uint32_t>& order = out.components.order;
  const std::vector<std::uint32_t>& of = out.components.of;
  const bool without_fin = condition.fin_marks().empty();  // then the marks of all its branches decide
  for (std::size_t i = 0; i < order.size();) {             // successors first
    const std::size_t begin = i;
    const std::uint32_t name = of[order[i]];
    bool cyclic = false, live = false;
    Marks met;
    for (; i < order.size() && of[order[i]] == name; ++i)
      for (const Branch& b : graph.branches(order[i])) {
        live = live || out.live[b.target];
        if (of[b.target] != name) continue;
        cyclic = true;
        met = met | b.marks;
      }
    const auto states = [&] {
      States all(order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(i));
      std::sort(all.begin(), all.end());
      return all;
    };
    const bool accepting =
        cyclic && (condition.holds(met) || (!without_fin && component_accepts(graph, states(), condition)));
    for (std::size_t j = begin; j < i; ++j) out.live[order[j]] = live || accepting;
    out.accepting.push_back(accepting);
  }
  return out;
}

bool is_empty(const TransitionRelation& automaton) {
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
      for (const Branch& b : automaton.next(StateId{q}, word[i])) graph.add(source, {after + b.target, b.marks});
    }
  return live_components(graph, automaton.acceptance().condition).live[automaton.initial().index];
}

}  // namespace waymark::automata
