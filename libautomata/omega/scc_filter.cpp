#include "libautomata/omega/scc_filter.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

constexpr std::uint32_t absent = UINT32_MAX;

// One component's marks, before and after.
class ComponentMarks {
 public:
  ComponentMarks(const BranchGraph& graph, const std::vector<std::uint32_t>& states, std::uint32_t sets, MarksOn marks,
                 Budget& budget)
      : graph_(graph), states_(states), sets_(sets), marks_(marks) {
    for (std::uint32_t i = 0; i < states.size(); ++i) number_.emplace(states[i], i);
    for (std::uint32_t mark = 0; mark < sets; ++mark) {
      budget.step(states.size());
      without(mark);
    }
    if (marks == MarksOn::States) {
      for (std::uint32_t i = 0; i < sets; ++i) kept_.push_back(i);
    } else {
      collect();
      reduce();
    }
  }
  std::uint32_t needed() const { return static_cast<std::uint32_t>(kept_.size()); }

  // Of a branch from the component, inside it or (marks on states) out of it; over `sets` new ones.
  Marks image(std::uint32_t source, const Branch& branch, std::uint32_t sets) const {
    const Marks full = saturated(source, branch);
    Marks out = Marks::first(sets).without(Marks::first(needed()));
    for (std::uint32_t i = 0; i < kept_.size(); ++i)
      if (full.contains(kept_[i])) out = out | Marks::of(i);
    return out;
  }

 private:
  void without(std::uint32_t mark) {
    BranchGraph part;
    for (std::size_t i = 0; i < states_.size(); ++i) part.add_state();
    for (std::uint32_t i = 0; i < states_.size(); ++i)
      for (const Branch& b : graph_.branches(states_[i]))
        if (const auto to = number_.find(b.target); to != number_.end() && !b.marks.contains(mark))
          part.add(i, {to->second, {}});
    parts_.push_back(components(part));
    cyclic_.emplace_back(parts_.back().count, false);
    for (std::uint32_t i = 0; i < states_.size(); ++i)
      for (const Branch& b : part.branches(i))
        if (parts_.back().of[i] == parts_.back().of[b.target]) cyclic_.back()[parts_.back().of[i]] = true;
  }
  Marks saturated(std::uint32_t source, const Branch& branch) const {
    Marks out = branch.marks;
    const std::uint32_t from = number_.at(source);
    const std::uint32_t to = marks_ == MarksOn::States ? from : number_.at(branch.target);
    for (std::uint32_t mark = 0; mark < sets_; ++mark)
      if (marks_ == MarksOn::States ? !cyclic_[mark][parts_[mark].of[from]]
                                    : parts_[mark].of[from] != parts_[mark].of[to])
        out = out | Marks::of(mark);
    return out;
  }
  void collect() {
    for (std::uint32_t q : states_)
      for (const Branch& b : graph_.branches(q))
        if (number_.contains(b.target)) inside_.push_back(saturated(q, b));
    std::sort(inside_.begin(), inside_.end());
    inside_.erase(std::unique(inside_.begin(), inside_.end()), inside_.end());
  }
  // Set j goes when it is everywhere, or when every branch in some other set i that stays is in j.
  void reduce() {
    for (std::uint32_t i = 0; i < sets_; ++i) kept_.push_back(i);
    for (std::size_t at = kept_.size(); at-- > 0;) {
      const std::uint32_t j = kept_[at];
      const auto in_j = [&](Marks m) { return m.contains(j); };
      const auto implies_j = [&](std::uint32_t i) {
        return i != j &&
               std::all_of(inside_.begin(), inside_.end(), [&](Marks m) { return !m.contains(i) || m.contains(j); });
      };
      if (std::all_of(inside_.begin(), inside_.end(), in_j) || std::any_of(kept_.begin(), kept_.end(), implies_j))
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }

  const BranchGraph& graph_;
  std::vector<std::uint32_t> states_;
  std::uint32_t sets_;
  std::unordered_map<std::uint32_t, std::uint32_t> number_;  // of the component's states
  MarksOn marks_;
  std::vector<Components> parts_;          // by mark: the component without it
  std::vector<std::vector<bool>> cyclic_;  // by mark and component of that part: it has a cycle
  std::vector<Marks> inside_;              // distinct, saturated
  std::vector<std::uint32_t> kept_;
};

bool has_cycle(const BranchGraph& graph, const Components& found, std::uint32_t component) {
  for (std::uint32_t q = 0; q < graph.size(); ++q)
    for (const Branch& b : graph.branches(q))
      if (found.of[q] == component && found.of[b.target] == component) return true;
  return false;
}

}  // namespace

TransitionRelation nothing_accepted() {
  TransitionRelation out;
  out.roots.push_back(Mtbdd::terminal(Choices::none));
  return out;
}

TransitionRelation trim(const TransitionRelation& automaton) {
  const TransitionRelation reached = canonical(automaton);
  const LiveComponents live = live_components(BranchGraph(reached), reached.acceptance.condition);
  if (!live.live[reached.initial]) return nothing_accepted();
  std::vector<std::uint32_t> kept, number(reached.states(), 0);
  for (std::uint32_t q = 0; q < reached.states(); ++q) {
    if (!live.live[q]) continue;
    number[q] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(q);
  }
  TransitionRelation out = rebuild(reached, kept, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches;
    for (const Branch& b : choice)
      if (live.live[b.target]) branches.push_back({number[b.target], b.marks});
    return branches;
  });
  out.initial = number[reached.initial];
  return out;
}

TransitionRelation scc_filter(const TransitionRelation& automaton, MarksOn marks_on, Budget& budget) {
  if (!automaton.acceptance.is_generalized_buchi())
    throw std::invalid_argument("scc_filter: the acceptance is not generalised Büchi");
  const TransitionRelation reached = canonical(automaton);
  const BranchGraph graph(reached);
  const LiveComponents live = live_components(graph, reached.acceptance.condition);
  if (!live.live[reached.initial]) return nothing_accepted();

  const Components& found = live.components;
  std::vector<std::vector<std::uint32_t>> states(found.count);
  std::vector<std::uint32_t> kept, number(graph.size(), absent);
  for (std::uint32_t q = 0; q < graph.size(); ++q) {
    states[found.of[q]].push_back(q);
    if (!live.live[q]) continue;
    number[q] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(q);
  }
  std::vector<std::optional<ComponentMarks>> marks(found.count);
  std::uint32_t sets = 0;
  bool rejecting_cycle = false;
  for (std::uint32_t c = 0; c < found.count; ++c) {
    if (live.accepting[c]) {
      marks[c].emplace(graph, states[c], reached.acceptance.sets, marks_on, budget);
      sets = std::max(sets, marks[c]->needed());
    } else if (live.live[states[c].front()]) {
      rejecting_cycle = rejecting_cycle || has_cycle(graph, found, c);
    }
  }
  if (sets == 0 && rejecting_cycle) sets = 1;
  TransitionRelation out = rebuild(reached, kept, [&](std::uint32_t source, std::span<const Branch> choice) {
    std::vector<Branch> branches;
    for (const Branch& b : choice) {
      budget.step();
      if (number[b.target] == absent) continue;
      const std::uint32_t c = found.of[source];
      const bool inside = live.accepting[c] && (marks_on == MarksOn::States || c == found.of[b.target]);
      branches.push_back({number[b.target], inside ? marks[c]->image(source, b, sets) : Marks()});
    }
    return branches;
  });
  out.initial = number[reached.initial];
  out.acceptance = Acceptance::generalized_buchi(sets);
  return out;
}

std::optional<TransitionRelation> with_free_marks(const TransitionRelation& automaton) {
  const Components found = components(BranchGraph(automaton));
  const Marks full = Marks::first(automaton.acceptance.sets);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  bool changed = false;
  TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t source, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) {
      if (found.of[source] == found.of[b.target] || b.marks == full) continue;
      b.marks = full;
      changed = true;
    }
    return branches;
  });
  if (!changed) return std::nullopt;
  return out;
}

}  // namespace waymark::automata
