#include "libplan/product/task_table.hpp"

#include "libautomata/graph/scc.hpp"

namespace waymark::plan {

using automata::StateId;

struct TaskTable::Unordered {
  std::uint32_t initial = trap;
  std::vector<std::vector<std::uint32_t>> steps, jumps;  // by state; steps by class
  std::vector<bool> goal;
};

TaskTable::TaskTable(const automata::Dfa& dfa, const Letters& letters) : TaskTable(dfa, letters, false) {}

TaskTable TaskTable::never(const automata::Dfa& dfa, const Letters& letters) { return {dfa, letters, true}; }

TaskTable::TaskTable(const automata::Dfa& dfa, const Letters& letters, bool never)
    : classes_(letters, dfa.vocabulary(), dfa.reads(), UnknownProposition::NeverHolds),
      row_(static_cast<std::uint32_t>(classes_.size())) {
  const auto leads_nowhere = [&](StateId q) { return never ? dfa.is_accepting(q) : dfa.is_trap(q); };
  Unordered out;
  out.initial = leads_nowhere(dfa.initial()) ? trap : dfa.initial().index;
  out.jumps.resize(dfa.states());
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    out.goal.push_back(never ? dfa.is_trap(StateId{q}) : dfa.is_accepting(StateId{q}));
    std::vector<std::uint32_t>& row = out.steps.emplace_back();
    for (const ltl::Letter& letter : classes_.representatives()) {
      const StateId target = out.goal[q] ? StateId{q} : dfa.next(StateId{q}, letter);
      row.push_back(leads_nowhere(target) ? trap : target.index | (never ? marked : 0));
    }
  }
  adopt(out);
}

TaskTable::TaskTable(const automata::MdpSafe& automaton, const Letters& letters)
    : classes_(letters, automaton.vocabulary(), automaton.reads(), UnknownProposition::NeverHolds),
      row_(static_cast<std::uint32_t>(classes_.size())) {
  Unordered out;
  out.initial = automaton.initial().index;
  out.goal.assign(automaton.states(), false);
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    std::vector<std::uint32_t>& row = out.steps.emplace_back();
    for (const ltl::Letter& letter : classes_.representatives()) {
      const auto step = automaton.next(StateId{q}, letter);
      row.push_back(step ? step->target.index | (step->accepting ? marked : 0) : trap);
    }
    std::vector<std::uint32_t>& jumps = out.jumps.emplace_back();
    for (StateId target : automaton.jumps(StateId{q})) jumps.push_back(target.index);
  }
  adopt(out);
}

TaskTable::Lists TaskTable::lists_of(const std::vector<std::vector<std::uint32_t>>& rows) {
  Lists out;
  out.first.push_back(0);
  for (const auto& row : rows) {
    out.values.insert(out.values.end(), row.begin(), row.end());
    out.first.push_back(static_cast<std::uint32_t>(out.values.size()));
  }
  return out;
}

void TaskTable::adopt(const Unordered& unordered) {
  struct Graph {
    std::vector<std::vector<std::uint32_t>> targets;
    std::size_t size() const { return targets.size(); }
    const std::vector<std::uint32_t>& successors(std::uint32_t q) const { return targets[q]; }
  };
  const auto size = static_cast<std::uint32_t>(unordered.steps.size());
  Graph graph{unordered.jumps};
  for (std::uint32_t q = 0; q < size; ++q)
    for (std::uint32_t step : unordered.steps[q])
      if ((step & trap) != trap) graph.targets[q].push_back(step & trap);
  const automata::Components found = automata::components(graph);
  std::vector<std::uint32_t> number(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    number[found.order[i]] = i;
    if (i == 0 || found.of[found.order[i]] != found.of[found.order[i - 1]]) components_.push_back(i);
  }
  components_.push_back(size);
  origin_ = found.order;
  if (unordered.initial != trap) {
    initial_states_.push_back(number[unordered.initial]);
    for (std::uint32_t target : unordered.jumps[unordered.initial]) initial_states_.push_back(number[target]);
  }
  std::vector<std::vector<std::uint32_t>> jumps(size), sources(size), jump_sources(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t q = found.order[i];
    goal_.push_back(unordered.goal[q]);
    for (std::uint32_t step : unordered.steps[q]) {
      const std::uint32_t target = step & trap;
      steps_.push_back(target == trap ? trap : number[target] | (step & marked));
      has_marks_ = has_marks_ || (target != trap && (step & marked) != 0);
      if (target != trap && (sources[number[target]].empty() || sources[number[target]].back() != i))
        sources[number[target]].push_back(i);
    }
    for (std::uint32_t target : unordered.jumps[q]) {
      jumps[i].push_back(number[target]);
      jump_sources[number[target]].push_back(i);
    }
  }
  jumps_ = lists_of(jumps);
  sources_ = lists_of(sources);
  jump_sources_ = lists_of(jump_sources);
}

}  // namespace waymark::plan
