#include "libautomata/omega/lasso.hpp"

#include <algorithm>
#include <utility>

#include "libautomata/boolean.hpp"
#include "libautomata/omega/edges.hpp"
#include "libautomata/scc.hpp"

namespace waymark::automata {
namespace {

struct Step {
  std::uint32_t source;
  Branch branch;
};

// Some of the edges of an automaton, by source.
class Part {
 public:
  explicit Part(std::size_t states) : edges_(states), targets_(states) {}
  void add(const Step& step) {
    edges_[step.source].push_back(step);
    targets_[step.source].push_back(step.branch.target);
  }
  std::size_t size() const { return edges_.size(); }
  const std::vector<std::uint32_t>& successors(std::uint32_t q) const { return targets_[q]; }
  const std::vector<Step>& edges(std::uint32_t q) const { return edges_[q]; }

  // Shortest path from a state to an edge that is wanted, that edge included; empty when there is none.
  template <class Wanted>
  std::vector<Step> path(std::uint32_t from, const Wanted& wanted) const {
    std::vector<std::optional<Step>> before(size());
    std::vector<std::uint32_t> queue{from};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const Step& step : edges_[queue[i]]) {
        if (wanted(step)) return unwound(step, from, before);
        if (step.branch.target == from || before[step.branch.target]) continue;
        before[step.branch.target] = step;
        queue.push_back(step.branch.target);
      }
    return {};
  }

 private:
  static std::vector<Step> unwound(Step last, std::uint32_t from,
                                   const std::vector<std::optional<Step>>& before) {
    std::vector<Step> out{last};
    while (out.back().source != from) out.push_back(*before[out.back().source]);
    std::reverse(out.begin(), out.end());
    return out;
  }

  std::vector<std::vector<Step>> edges_;
  std::vector<std::vector<std::uint32_t>> targets_;
};

Condition without_fin(const Condition& condition, std::uint32_t mark) {
  using Op = Condition::Op;
  if (condition.op() == Op::Fin && condition.mark() == mark) return Condition::constant(false);
  if (condition.op() != Op::And && condition.op() != Op::Or) return condition;
  std::vector<Condition> operands;
  for (const Condition& operand : condition.operands()) operands.push_back(without_fin(operand, mark));
  return condition.op() == Op::And ? Condition::all_of(std::move(operands))
                                   : Condition::any_of(std::move(operands));
}

// A strongly connected part whose marks together satisfy the condition.
struct Accepting {
  Part part;
  Marks marks;
};

std::optional<Accepting> accepting_part(const Part& part, const Condition& condition) {
  if (condition.op() == Condition::Op::False) return std::nullopt;
  const Components found = components(part);
  std::vector<std::vector<std::uint32_t>> members(found.count);
  for (std::uint32_t q = 0; q < part.size(); ++q) members[found.of[q]].push_back(q);
  for (const std::vector<std::uint32_t>& states : members) {
    Part inside(part.size());
    Marks marks;
    bool cyclic = false;
    for (std::uint32_t q : states)
      for (const Step& step : part.edges(q)) {
        if (found.of[step.branch.target] != found.of[q]) continue;
        inside.add(step);
        marks = marks | step.branch.marks;
        cyclic = true;
      }
    if (!cyclic) continue;
    if (condition.holds(marks)) return Accepting{std::move(inside), marks};
    const Marks offending = marks & condition.fin_marks();
    if (offending.empty()) continue;  // all marks are met and no Fin is hurt: fewer marks satisfy no more
    const std::uint32_t mark = offending.members().front();
    Part avoiding(part.size());
    for (std::uint32_t q : states)
      for (const Step& step : inside.edges(q))
        if (!step.branch.marks.contains(mark)) avoiding.add(step);
    if (std::optional<Accepting> avoided = accepting_part(avoiding, condition)) return avoided;
    if (std::optional<Accepting> met = accepting_part(inside, without_fin(condition, mark))) return met;
  }
  return std::nullopt;
}

// From and back to a state, past every mark of the part.
std::vector<Step> cycle(const Accepting& accepting, std::uint32_t from) {
  std::vector<Step> out;
  Marks missing = accepting.marks;
  std::uint32_t at = from;
  const auto append = [&](const std::vector<Step>& path) {
    for (const Step& step : path) {
      out.push_back(step);
      missing = missing.without(step.branch.marks);
      at = step.branch.target;
    }
  };
  while (!missing.empty())
    append(accepting.part.path(at, [&](const Step& step) { return !(step.branch.marks & missing).empty(); }));
  if (at != from || out.empty())
    append(accepting.part.path(at, [&](const Step& step) { return step.branch.target == from; }));
  return out;
}

// Some letter on which the step may be taken.
ltl::Letter letter(const Step& step, BranchLetters& letters, const Automaton& automaton) {
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
Part reachable(const Branching& automaton) {
  Part all(automaton.states());
  std::vector<bool> seen(automaton.states(), false);
  std::vector<std::uint32_t> queue{automaton.initial};
  seen[automaton.initial] = true;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const Branch& branch : branches_of(automaton, queue[i])) {
      all.add({queue[i], branch});
      if (seen[branch.target]) continue;
      seen[branch.target] = true;
      queue.push_back(branch.target);
    }
  return all;
}

}  // namespace

std::optional<ltl::Lasso> find_lasso(const Automaton& automaton) {
  const Branching& transitions = automaton.transitions();
  const Part all = reachable(transitions);
  const std::optional<Accepting> accepting = accepting_part(all, automaton.acceptance().condition);
  if (!accepting) return std::nullopt;
  const auto inside = [&](std::uint32_t q) { return !accepting->part.edges(q).empty(); };
  std::vector<Step> prefix;
  if (!inside(transitions.initial))
    prefix = all.path(transitions.initial, [&](const Step& step) { return inside(step.branch.target); });
  const std::uint32_t entry = prefix.empty() ? transitions.initial : prefix.back().branch.target;
  BranchLetters letters(transitions);
  std::vector<ltl::Letter> u, v;
  for (const Step& step : prefix) u.push_back(letter(step, letters, automaton));
  for (const Step& step : cycle(*accepting, entry)) v.push_back(letter(step, letters, automaton));
  return ltl::Lasso(std::move(u), std::move(v));
}

}  // namespace waymark::automata
