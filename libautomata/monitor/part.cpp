#include "libautomata/monitor/part.hpp"

#include <algorithm>
#include <tuple>

namespace waymark::automata {
namespace {

// A DFA as a transition relation without marks: `lost` states are left out.
TransitionRelation as_relation(const Dfa& dfa, const std::vector<bool>& lost) {
  TransitionRelation out;
  std::vector<Mtbdd::Node> roots;
  for (std::uint32_t q = 0; q < dfa.states(); ++q) roots.push_back(dfa.root({q}));
  const auto leaf = [&](std::uint32_t target) {
    return Mtbdd::terminal(lost[target] ? Choices::none : out.choices.intern({{target, {}}}));
  };
  out.roots = out.diagram.import(dfa.diagram(), roots, leaf, [](Mtbdd::Variable v) { return v; });
  out.initial = dfa.initial().index;
  return out;
}

// From each state: fewest branches to one that `is_goal` names, counting that one.
template <class IsGoal>
std::vector<std::uint32_t> branches_to(const TransitionRelation& relation, const IsGoal& is_goal) {
  std::vector<std::uint32_t> out(relation.states(), UINT32_MAX);
  std::vector<std::vector<std::uint32_t>> sources(relation.states());
  std::vector<std::uint32_t> queue;
  ChoiceLists lists(relation);
  for (std::uint32_t q = 0; q < relation.states(); ++q) {
    bool found = false;
    for (const Branch& b : lists.branches(q)) {
      sources[b.target].push_back(q);
      found = found || is_goal(b);
    }
    if (!found) continue;
    out[q] = 1;
    queue.push_back(q);
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const std::uint32_t q : sources[queue[i]])
      if (out[q] == UINT32_MAX) {
        out[q] = out[queue[i]] + 1;
        queue.push_back(q);
      }
  return out;
}

}  // namespace

Part::Part(const Automaton& trimmed) : relation_(trimmed.transitions()), reads_(trimmed.reads()) {
  find_distances();
  place_of({});
  // A trimmed automaton has its initial state, even where it accepts nothing.
  const bool is_empty = branches_of(relation_, relation_.initial).empty();
  initial_ = is_empty ? nowhere : place_of({relation_.initial});
}

Part::Part(const Dfa& dfa, bool complement) : reads_(dfa.reads()) {
  std::vector<bool> lost(dfa.states(), false);
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    is_final_.push_back(dfa.is_accepting({q}) != complement);
    lost[q] = !complement && dfa.is_trap({q});
  }
  relation_ = as_relation(dfa, lost);
  if (complement) {  // lost: no rejecting state is reached
    std::vector<std::uint32_t> distance = branches_to(relation_, [&](const Branch& b) { return is_final_[b.target]; });
    for (std::uint32_t q = 0; q < dfa.states(); ++q) lost[q] = !is_final_[q] && distance[q] == UINT32_MAX;
    relation_ = as_relation(dfa, lost);
  }
  find_distances();
  place_of({});
  initial_ = place_of({relation_.initial});
}

void Part::find_distances() {
  const Marks all = Marks::first(relation_.acceptance.sets);
  distance_ = branches_to(
      relation_, [&](const Branch& b) { return is_final_.empty() ? b.marks.includes(all) : is_final_[b.target]; });
}

Part::Place Part::place_of(std::vector<std::uint32_t> states) {
  const auto [at, fresh] = number_.try_emplace(std::move(states), static_cast<Place>(states_of_.size()));
  if (!fresh) return at->second;
  states_of_.push_back(at->first);
  const std::vector<std::uint32_t>& some = states_of_.back();
  accepts_.push_back(!is_final_.empty() &&
                     std::any_of(some.begin(), some.end(), [&](std::uint32_t q) { return is_final_[q]; }));
  moves_.emplace_back();
  return at->second;
}

Part::Place Part::next(Place from, const ltl::Letter& letter) {
  const auto holds = [&](Mtbdd::Variable v) { return letter.contains(reads_[v]); };
  std::vector<std::uint32_t> targets;
  for (const std::uint32_t q : states_of_[from])
    for (const Branch& b : relation_.choices[Mtbdd::payload(relation_.diagram.evaluate(relation_.roots[q], holds))])
      targets.push_back(b.target);
  std::sort(targets.begin(), targets.end());
  targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  return place_of(std::move(targets));
}

Part::Place Part::keep_only(Place place) {
  std::vector<std::uint32_t> states = states_of_[place], first = states_of_[initial_];
  number_.clear();
  states_of_.clear();
  accepts_.clear();
  moves_.clear();
  place_of({});
  initial_ = place_of(std::move(first));
  return place_of(std::move(states));
}

std::uint32_t Part::distance_of(const Branch& branch) const {
  const bool arrives = is_final_.empty() ? branch.marks.includes(Marks::first(relation_.acceptance.sets))
                                         : static_cast<bool>(is_final_[branch.target]);
  const std::uint32_t rest = distance_[branch.target];
  return arrives ? 0 : rest == UINT32_MAX ? rest : rest + 1;
}

// false: too many paths.
bool Part::add_moves(std::uint32_t state, std::vector<Move>& out) {
  std::vector<Literal> cube;
  const auto walk = [&](auto&& self, Mtbdd::Node n) -> bool {
    if (Mtbdd::is_terminal(n)) {
      for (const Branch& b : relation_.choices[Mtbdd::payload(n)]) out.push_back({cube, b.target, b.marks});
      return out.size() <= most_moves;
    }
    for (const bool value : {false, true}) {
      cube.push_back({reads_[relation_.diagram.variable(n)], value});
      if (!self(self, value ? relation_.diagram.high(n) : relation_.diagram.low(n))) return false;
      cube.pop_back();
    }
    return true;
  };
  return walk(walk, relation_.roots[state]);
}

const std::optional<std::vector<Part::Move>>& Part::moves(Place from) {
  if (moves_[from]) return *moves_[from];
  std::vector<Move> found;
  for (const std::uint32_t q : states_of_[from])
    if (!add_moves(q, found)) return moves_[from].emplace();
  const auto rank = [&](const Move& m) {
    const Branch branch{m.target, m.marks};
    return std::tuple(distance_of(branch), relation_.acceptance.sets - m.marks.count(), m.cube.size());
  };
  std::stable_sort(found.begin(), found.end(), [&](const Move& a, const Move& b) { return rank(a) < rank(b); });
  for (Move& m : found) m.target = place_of({m.target});
  return moves_[from].emplace(std::move(found));
}

}  // namespace waymark::automata
