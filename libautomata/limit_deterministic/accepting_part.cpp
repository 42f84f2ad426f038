#include "libautomata/limit_deterministic/accepting_part.hpp"

#include <algorithm>
#include <numeric>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/simulation.hpp"

namespace waymark::automata {
namespace {

struct Unmarked {  // the graph without marked edges
  std::vector<std::vector<std::uint32_t>> targets;
  std::size_t size() const { return targets.size(); }
  const std::vector<std::uint32_t>& successors(std::uint32_t q) const { return targets[q]; }
};

TransitionRelation with_all_marks(const TransitionRelation& automaton) {
  const BranchGraph graph(automaton);
  Unmarked unmarked{std::vector<std::vector<std::uint32_t>>(graph.size())};
  for (std::uint32_t q = 0; q < graph.size(); ++q)
    for (const Branch& b : graph.branches(q))
      if (b.marks.empty()) unmarked.targets[q].push_back(b.target);
  const Components found = components(unmarked);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  return rebuild(automaton, all, [&](std::uint32_t q, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches)
      if (found.of[q] != found.of[b.target]) b.marks = Marks::of(0);
    return branches;
  });
}

}  // namespace

std::uint32_t AcceptingPart::add(const TransitionRelation& part) {
  const auto first = static_cast<std::uint32_t>(automaton.states());
  const auto leaf = [&](std::uint32_t c) {
    std::vector<Branch> branches(part.choices[c].begin(), part.choices[c].end());
    for (Branch& b : branches) b.target += first;
    return Mtbdd::terminal(automaton.choices.intern(std::move(branches)));
  };
  for (Mtbdd::Node root : automaton.diagram.import(part.diagram, part.roots, leaf, [](Mtbdd::Variable v) { return v; }))
    automaton.roots.push_back(root);
  return first;
}

MergedAcceptingPart merged(const AcceptingPart& accepting_part, Budget& budget) {
  MergedAcceptingPart out;
  if (accepting_part.automaton.states() == 0) return out;
  Quotient quotient = bisimulation(with_all_marks(accepting_part.automaton), budget);
  out.accepting_part.automaton = std::move(quotient.automaton);
  out.number = std::move(quotient.number);
  return out;
}

Choosing::Choosing(const AcceptingPart& accepting_part) : reached_(accepting_part.automaton.states(), false) {
  const BranchGraph graph(accepting_part.automaton);
  for (std::uint32_t q = 0; q < graph.size(); ++q) {
    std::vector<std::uint32_t>& targets = successors_.emplace_back();
    for (std::uint32_t target : graph.successors(q)) targets.push_back(target);
  }
}

std::vector<std::uint32_t> Choosing::choose(const std::vector<std::vector<std::uint32_t>>& requests) {
  Answers alone = one_by_one(requests);
  Answers shared = by_most_answered(requests);
  return std::move((shared.states < alone.states ? shared : alone).chosen);
}

Choosing::Answers Choosing::one_by_one(const Requests& requests) {
  Answers out = none(requests);
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return requests[i].size() < requests[j].size(); });
  for (std::size_t i : order) {
    std::size_t fewest = SIZE_MAX;
    for (std::uint32_t option : requests[i]) {
      const std::size_t more = added(option);
      if (more >= fewest) continue;
      fewest = more;
      out.chosen[i] = option;
    }
    reach(out.chosen[i]);
  }
  out.states = count_reached();
  return out;
}

Choosing::Answers Choosing::by_most_answered(const Requests& requests) {
  Answers out = none(requests);
  std::vector<std::vector<std::size_t>> asking(successors_.size());  // by state: requests that it answers
  for (std::size_t i = 0; i < requests.size(); ++i)
    for (std::uint32_t option : requests[i]) asking[option].push_back(i);
  std::vector<bool> open(requests.size(), true);
  for (;;) {
    std::size_t best_added = 0, best_answered = 0;
    std::uint32_t best = 0;
    for (std::uint32_t state = 0; state < asking.size(); ++state) {
      const auto answered = static_cast<std::size_t>(
          std::count_if(asking[state].begin(), asking[state].end(), [&](std::size_t i) { return open[i]; }));
      if (answered == 0) continue;
      const std::size_t more = added(state);
      if (best_answered != 0 && more * best_answered >= best_added * answered) continue;
      best = state;
      best_added = more;
      best_answered = answered;
    }
    if (best_answered == 0) break;
    for (std::size_t i : asking[best]) {
      if (open[i]) out.chosen[i] = best;
      open[i] = false;
    }
    reach(best);
  }
  out.states = count_reached();
  return out;
}

Choosing::Answers Choosing::none(const Requests& requests) {
  reached_.assign(successors_.size(), false);
  return {std::vector<std::uint32_t>(requests.size()), 0};
}

std::size_t Choosing::count_reached() const {
  return static_cast<std::size_t>(std::count(reached_.begin(), reached_.end(), true));
}

std::size_t Choosing::added(std::uint32_t state) const {
  if (reached_[state]) return 0;
  std::vector<bool> met = reached_;
  std::vector<std::uint32_t> queue{state};
  met[state] = true;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (std::uint32_t target : successors_[queue[i]]) {
      if (!met[target]) queue.push_back(target);
      met[target] = true;
    }
  return queue.size();
}

void Choosing::reach(std::uint32_t state) {
  std::vector<std::uint32_t> stack{state};
  while (!stack.empty()) {
    const std::uint32_t q = stack.back();
    stack.pop_back();
    if (reached_[q]) continue;
    reached_[q] = true;
    stack.insert(stack.end(), successors_[q].begin(), successors_[q].end());
  }
}

}  // namespace waymark::automata
