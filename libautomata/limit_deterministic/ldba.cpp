#include "libautomata/limit_deterministic/ldba.hpp"

#include <algorithm>
#include <utility>

#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
constexpr std::uint32_t unseen = UINT32_MAX;

// By state: some run from it accepts, jumps taken.
std::vector<bool> live_states(const LimitDeterministic& ldba) {
  BranchGraph graph(ldba.automaton);
  for (std::uint32_t q = 0; q < graph.size(); ++q)
    for (std::uint32_t target : ldba.jumps[q]) graph.add(q, {target, {}});
  return live_components(graph, ldba.automaton.acceptance.condition).live;
}

// Live states in breadth-first order; the initial state even when nothing is accepted.
std::vector<std::uint32_t> order_of(const LimitDeterministic& ldba, const std::vector<bool>& live) {
  std::vector<std::uint32_t> order{ldba.automaton.initial};
  std::vector<bool> met(ldba.automaton.states(), false);
  met[order.front()] = true;
  const auto meet = [&](std::uint32_t q) {
    if (live[q] && !met[q]) order.push_back(q);
    met[q] = true;
  };
  ChoiceLists lists(ldba.automaton);
  for (std::size_t i = 0; i < order.size(); ++i) {  // the order doubles as the queue
    for (std::uint32_t c : lists.of(order[i]))
      for (const Branch& b : ldba.automaton.choices[c]) meet(b.target);
    for (std::uint32_t target : ldba.jumps[order[i]]) meet(target);
  }
  return order;
}

TransitionRelation branches_of_runs(const LimitDeterministic& ldba) {
  Budget unlimited;
  return without_jumps(ldba, unlimited);
}

}  // namespace

LimitDeterministic canonical(const LimitDeterministic& ldba) {
  const std::vector<bool> live = live_states(ldba);
  const std::vector<std::uint32_t> order = order_of(ldba, live);
  std::vector<std::uint32_t> number(ldba.automaton.states(), unseen);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  LimitDeterministic out;
  out.automaton = rebuild(ldba.automaton, order, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches;
    for (const Branch& b : choice)
      if (live[b.target]) branches.push_back({number[b.target], b.marks});
    return branches;
  });
  out.automaton.initial = 0;
  for (std::uint32_t q : order) {
    out.accepting_part.push_back(ldba.accepting_part[q]);
    std::vector<std::uint32_t>& jumps = out.jumps.emplace_back();
    for (std::uint32_t target : ldba.jumps[q])
      if (live[target]) jumps.push_back(number[target]);
  }
  return out;
}

TransitionRelation without_jumps(const LimitDeterministic& ldba, Budget& budget) {
  TransitionRelation out = ldba.automaton;
  const Mtbdd::Operation operation = out.diagram.operation();
  for (std::uint32_t q = 0; q < out.states(); ++q)
    for (std::uint32_t target : ldba.jumps[q])
      out.roots[q] = unite(out, operation, out.roots[q], ldba.automaton.roots[target], budget);
  return out;
}

MdpSafe::MdpSafe(LimitDeterministic ldba, const ltl::Vocabulary& vocabulary, std::vector<ltl::Proposition> reads)
    : branches_(vocabulary, std::move(reads), branches_of_runs(ldba)),
      steps_(std::move(ldba.automaton)),
      accepting_part_(std::move(ldba.accepting_part)) {
  for (const std::vector<std::uint32_t>& targets : ldba.jumps) {
    std::vector<StateId>& jumps = jumps_.emplace_back();
    for (std::uint32_t target : targets) jumps.push_back(StateId{target});
  }
}

bool MdpSafe::is_deterministic() const {
  return std::all_of(jumps_.begin(), jumps_.end(), [](const auto& jumps) { return jumps.empty(); });
}

std::optional<MdpSafe::Transition> MdpSafe::next(StateId q, const ltl::Letter& letter) const {
  const auto holds = [&](Mtbdd::Variable v) { return letter.contains(reads()[v]); };
  const auto choice = steps_.choices[Mtbdd::payload(steps_.diagram.evaluate(steps_.roots[q.index], holds))];
  if (choice.empty()) return std::nullopt;
  return Transition{StateId{choice.front().target}, !choice.front().marks.empty()};
}

}  // namespace waymark::automata
