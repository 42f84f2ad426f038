#include "libautomata/omega/lasso.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/graph/scc.hpp"
#include "libautomata/omega/edges.hpp"

namespace waymark::automata {
namespace {

struct SourcedBranch {
  std::uint32_t source;
  Branch branch;
};

// Some of the states of an automaton, and some of the edges between them. Vertices are positions in `states`.
class Subgraph {
 public:
  explicit Subgraph(std::vector<std::uint32_t> states)  // ascending
      : states_(std::move(states)), edges_(states_.size()), targets_(states_.size()) {}
  void add(const SourcedBranch& step) {  // O(log states)
    const std::uint32_t v = vertex(step.source);
    edges_[v].push_back(step);
    targets_[v].push_back(vertex(step.branch.target));
  }
  std::size_t size() const { return edges_.size(); }
  std::uint32_t state(std::uint32_t v) const { return states_[v]; }
  std::span<const std::uint32_t> successors(std::uint32_t v) const { return targets_[v]; }
  const std::vector<SourcedBranch>& edges(std::uint32_t v) const { return edges_[v]; }
  bool leaves(std::uint32_t q) const {  // some edge starts at the state
    const auto at = std::lower_bound(states_.begin(), states_.end(), q);
    return at != states_.end() && *at == q && !edges_[static_cast<std::size_t>(at - states_.begin())].empty();
  }

  // Shortest path from a state to an edge that is wanted, that edge included; empty when there is none.
  template <class Wanted>
  std::vector<SourcedBranch> path(std::uint32_t from, const Wanted& wanted) const {
    std::vector<std::optional<SourcedBranch>> before(size());  // by vertex
    std::vector<std::uint32_t> queue{vertex(from)};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (std::size_t e = 0; e < edges_[queue[i]].size(); ++e) {
        const SourcedBranch& step = edges_[queue[i]][e];
        if (wanted(step)) return unwound(step, from, before);
        const std::uint32_t target = targets_[queue[i]][e];
        if (step.branch.target == from || before[target]) continue;
        before[target] = step;
        queue.push_back(target);
      }
    return {};
  }

 private:
  std::uint32_t vertex(std::uint32_t q) const {
    return static_cast<std::uint32_t>(std::lower_bound(states_.begin(), states_.end(), q) - states_.begin());
  }
  std::vector<SourcedBranch> unwound(const SourcedBranch& last, std::uint32_t from,
                                     const std::vector<std::optional<SourcedBranch>>& before) const {
    std::vector<SourcedBranch> out{last};
    while (out.back().source != from) out.push_back(*before[vertex(out.back().source)]);
    std::reverse(out.begin(), out.end());
    return out;
  }

  std::vector<std::uint32_t> states_;
  std::vector<std::vector<SourcedBranch>> edges_;    // by vertex
  std::vector<std::vector<std::uint32_t>> targets_;  // vertices, by vertex
};

Condition without_fin(const Condition& condition, std::uint32_t mark) {
  using Op = Condition::Op;
  if (condition.op() == Op::Fin && condition.mark() == mark) return Condition::constant(false);
  if (condition.op() != Op::And && condition.op() != Op::Or) return condition;
  std::vector<Condition> operands;
  for (const Condition& operand : condition.operands()) operands.push_back(without_fin(operand, mark));
  return condition.op() == Op::And ? Condition::all_of(std::move(operands)) : Condition::any_of(std::move(operands));
}

// A strongly connected part whose marks together satisfy the condition.
struct Accepting {
  Subgraph part;
  Marks marks;
};

std::optional<Accepting> accepting_part(const Subgraph& part, const Condition& condition, Budget& budget) {
  if (condition.op() == Condition::Op::False) return std::nullopt;
  const Components found = components(part);
  for (std::size_t i = 0; i < found.order.size();) {
    const std::uint32_t name = found.of[found.order[i]];
    std::vector<std::uint32_t> members;
    for (; i < found.order.size() && found.of[found.order[i]] == name; ++i) members.push_back(found.order[i]);
    std::sort(members.begin(), members.end());
    std::vector<std::uint32_t> states;
    for (std::uint32_t v : members) states.push_back(part.state(v));
    Subgraph inside(states);
    Marks marks;
    bool cyclic = false;
    for (std::uint32_t v : members) {
      budget.step(1 + part.edges(v).size());
      for (std::size_t e = 0; e < part.edges(v).size(); ++e) {
        if (found.of[part.successors(v)[e]] != name) continue;
        const SourcedBranch& step = part.edges(v)[e];
        inside.add(step);
        marks = marks | step.branch.marks;
        cyclic = true;
      }
    }
    if (!cyclic) continue;
    if (condition.holds(marks)) return Accepting{std::move(inside), marks};
    const Marks offending = marks & condition.fin_marks();
    if (offending.empty()) continue;  // all marks are met and no Fin is hurt: fewer marks satisfy no more
    const std::uint32_t mark = offending.members().front();
    Subgraph avoiding(std::move(states));
    for (std::uint32_t v = 0; v < inside.size(); ++v)
      for (const SourcedBranch& step : inside.edges(v))
        if (!step.branch.marks.contains(mark)) avoiding.add(step);
    if (std::optional<Accepting> avoided = accepting_part(avoiding, condition, budget)) return avoided;
    if (std::optional<Accepting> met = accepting_part(inside, without_fin(condition, mark), budget)) return met;
  }
  return std::nullopt;
}

// From and back to a state, past every mark of the part.
std::vector<SourcedBranch> cycle(const Accepting& accepting, std::uint32_t from) {
  std::vector<SourcedBranch> out;
  Marks missing = accepting.marks;
  std::uint32_t at = from;
  const auto append = [&](const std::vector<SourcedBranch>& path) {
    for (const SourcedBranch& step : path) {
      out.push_back(step);
      missing = missing.without(step.branch.marks);
      at = step.branch.target;
    }
  };
  while (!missing.empty())
    append(accepting.part.path(at, [&](const SourcedBranch& step) { return !(step.branch.marks & missing).empty(); }));
  if (at != from || out.empty())
    append(accepting.part.path(at, [&](const SourcedBranch& step) { return step.branch.target == from; }));
  return out;
}

// Some letter on which the step may be taken.
ltl::Letter letter(const SourcedBranch& step, BranchLetters& letters, const Automaton& automaton) {
  ltl::Letter out;
  Mtbdd::Node n = letters.letters(step.source, step.branch);
  const Mtbdd& diagram = letters.diagram();
  while (!Mtbdd::is_terminal(n)) {
    const bool high = diagram.low(n) == Boolean::constant(false);
    if (high) out.insert(automaton.reads()[diagram.variable(n)]);
    n = high ? diagram.high(n) : diagram.low(n);
  }
  return out;
}

// The part that the initial state reaches.
Subgraph reachable(const TransitionRelation& automaton) {
  std::vector<bool> seen(automaton.states(), false);
  std::vector<std::uint32_t> states{automaton.initial};
  std::vector<SourcedBranch> steps;
  seen[automaton.initial] = true;
  ChoiceLists choices(automaton);
  for (std::size_t i = 0; i < states.size(); ++i)  // the list doubles as the queue
    for (const Branch& branch : choices.branches(states[i])) {
      steps.push_back({states[i], branch});
      if (seen[branch.target]) continue;
      seen[branch.target] = true;
      states.push_back(branch.target);
    }
  std::sort(states.begin(), states.end());
  Subgraph all(std::move(states));
  for (const SourcedBranch& step : steps) all.add(step);
  return all;
}

}  // namespace

std::optional<ltl::Lasso> find_lasso(const Automaton& automaton) {
  Budget budget;
  return find_lasso(automaton, budget);
}

std::optional<ltl::Lasso> find_lasso(const Automaton& automaton, Budget& budget) {
  const TransitionRelation& transitions = automaton.transitions();
  const Subgraph all = reachable(transitions);
  const std::optional<Accepting> accepting = accepting_part(all, automaton.acceptance().condition, budget);
  if (!accepting) return std::nullopt;
  const auto inside = [&](std::uint32_t q) { return accepting->part.leaves(q); };
  std::vector<SourcedBranch> prefix;
  if (!inside(transitions.initial))
    prefix = all.path(transitions.initial, [&](const SourcedBranch& step) { return inside(step.branch.target); });
  const std::uint32_t entry = prefix.empty() ? transitions.initial : prefix.back().branch.target;
  BranchLetters letters(transitions);
  std::vector<ltl::Letter> u, v;
  for (const SourcedBranch& step : prefix) u.push_back(letter(step, letters, automaton));
  for (const SourcedBranch& step : cycle(*accepting, entry)) v.push_back(letter(step, letters, automaton));
  return ltl::Lasso(std::move(u), std::move(v));
}

}  // namespace waymark::automata
