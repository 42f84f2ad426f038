#include "libautomata/hoa/claims.hpp"

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <unordered_map>

#include "libautomata/hoa/written_graph.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
using Op = HoaCondition::Op;
using Labels = HoaAutomaton::Labels;
using Refutation = std::optional<std::string>;

HoaCondition leaf(Op op, std::uint64_t set) {
  HoaCondition out;
  out.op = op;
  out.set = set;
  return out;
}

HoaCondition junction(Op op, std::vector<HoaCondition> operands) {
  HoaCondition out;
  out.op = op;
  out.operands = std::move(operands);
  return out;
}

std::string state_name(const HoaAutomaton::State& state) { return "state " + std::to_string(state.number); }

Refutation some_state(const HoaAutomaton& automaton, const std::string& does,
                      const std::function<bool(const HoaAutomaton::State&)>& test) {
  for (const HoaAutomaton::State& state : automaton.states)
    if (test(state)) return state_name(state) + " " + does;
  return std::nullopt;
}

bool marked_edge(const HoaAutomaton::State& state) {
  return std::any_of(state.edges.begin(), state.edges.end(),
                     [](const HoaAutomaton::Edge& edge) { return !edge.marks.empty(); });
}

bool branches(const HoaAutomaton::State& state) {
  return std::any_of(state.edges.begin(), state.edges.end(),
                     [](const HoaAutomaton::Edge& edge) { return edge.targets.size() > 1; });
}

bool universal_start(const HoaAutomaton& automaton) {
  return std::any_of(automaton.starts.begin(), automaton.starts.end(),
                     [](const auto& start) { return start.size() > 1; });
}

Refutation not_deterministic(HoaAutomaton& automaton) {
  if (automaton.starts.size() > 1) return "there are several initial states";
  Boolean logic(automaton.labels);
  return some_state(automaton, "has two edges for one letter", [&](const HoaAutomaton::State& state) {
    Node seen = Boolean::constant(false);
    for (const HoaAutomaton::Edge& edge : state.edges) {
      if (logic.conjunction(seen, edge.label) != Boolean::constant(false)) return true;
      seen = logic.disjunction(seen, edge.label);
    }
    return false;
  });
}

Refutation not_complete(HoaAutomaton& automaton) {
  if (automaton.starts.empty()) return "there is no initial state";
  Boolean logic(automaton.labels);
  std::set<std::uint64_t> defined;
  for (const HoaAutomaton::State& state : automaton.states) defined.insert(state.number);
  const auto undefined = [&](std::uint64_t number) { return !defined.contains(number); };
  for (const HoaAutomaton::State& state : automaton.states)
    for (const HoaAutomaton::Edge& edge : state.edges)
      for (std::uint64_t target : edge.targets)
        if (undefined(target)) return "state " + std::to_string(target) + " has no edges";
  return some_state(automaton, "has no edge for some letter", [&](const HoaAutomaton::State& state) {
    Node seen = Boolean::constant(false);
    for (const HoaAutomaton::Edge& edge : state.edges) seen = logic.disjunction(seen, edge.label);
    return seen != Boolean::constant(true);
  });
}

Refutation not_colored(const HoaAutomaton& automaton) {
  return some_state(automaton, "has an edge with no mark or several", [](const HoaAutomaton::State& state) {
    return std::any_of(state.edges.begin(), state.edges.end(), [&](const HoaAutomaton::Edge& edge) {
      std::set<std::uint64_t> marks(state.marks.begin(), state.marks.end());
      marks.insert(edge.marks.begin(), edge.marks.end());
      return marks.size() != 1;
    });
  });
}

Refutation not_weak(const HoaGraph& graph) {
  for (const HoaGraph::Component& component : graph.components())
    if (!component.uniform)
      return "edges among state " + std::to_string(component.states.front()) +
             " and its component have different marks";
  return std::nullopt;
}

Refutation not_very_weak(const HoaGraph& graph) {
  for (const HoaGraph::Component& component : graph.components())
    if (component.states.size() > 1)
      return "states " + std::to_string(component.states[0]) + " and " + std::to_string(component.states[1]) +
             " reach each other";
  return not_weak(graph);
}

// A rejecting cycle behind an accepting one, where all components are uniform.
Refutation not_terminal(const HoaGraph& graph, const HoaAutomaton& automaton) {
  if (automaton.sets > 64 || not_weak(graph)) return std::nullopt;
  const auto& components = graph.components();
  std::vector<bool> behind_acceptance(components.size(), false);
  for (std::size_t c = components.size(); c-- > 0;) {  // sources first
    if (!components[c].cyclic && !behind_acceptance[c]) continue;
    const bool accepting = components[c].cyclic && holds(automaton.acceptance, components[c].marks);
    if (behind_acceptance[c] && components[c].cyclic && !accepting)
      return "the cycle of state " + std::to_string(components[c].states.front()) +
             " rejects and lies behind one that accepts";
    if (!accepting && !behind_acceptance[c]) continue;
    for (std::uint32_t next : components[c].successors) behind_acceptance[next] = true;
  }
  return std::nullopt;
}

bool has_complemented(const HoaCondition& condition) {
  return condition.complemented ||
         std::any_of(condition.operands.begin(), condition.operands.end(), has_complemented);
}

Refutation not_the_named_acceptance(const HoaAutomaton& automaton) {
  static const std::set<std::string_view> known{"all",
                                                "none",
                                                "Buchi",
                                                "generalized-Buchi",
                                                "co-Buchi",
                                                "Streett",
                                                "Rabin",
                                                "generalized-co-Buchi",
                                                "generalized-Rabin",
                                                "parity"};
  if (!known.contains(automaton.acceptance_name.front().text)) return std::nullopt;
  const std::optional<NamedCondition> named = named_condition(automaton.acceptance_name);
  if (!named) return "this name does not take these parameters";
  if (named->sets != automaton.sets)
    return "it has " + std::to_string(named->sets) + " sets, not " + std::to_string(automaton.sets);
  if (has_complemented(automaton.acceptance)) return "it has no complemented sets";
  if (named->sets > 64) return std::nullopt;
  const bool all = named->sets <= 16;
  std::mt19937_64 random(1);
  for (std::uint64_t i = 0; i < (all ? std::uint64_t{1} << named->sets : 65'536); ++i) {
    const std::uint64_t marks = all ? i : random();
    if (holds(named->condition, marks) != holds(automaton.acceptance, marks))
      return "its condition is not the one of 'Acceptance:'";
  }
  return std::nullopt;
}

Refutation not_branching(const HoaAutomaton& automaton) {
  if (universal_start(automaton)) return std::nullopt;
  const bool some = std::any_of(automaton.states.begin(), automaton.states.end(), branches);
  return some ? std::nullopt : Refutation("there is no universal branch");
}

Refutation refute(std::string_view claim, HoaAutomaton& automaton, const HoaGraph& graph) {
  const auto labels = [&](Labels where, const std::string& does) {
    return some_state(automaton, does, [&](const auto& state) { return state.labels == where; });
  };
  if (claim == "trans-labels") return labels(Labels::State, "has a label itself");
  if (claim == "explicit-labels") return labels(Labels::Implied, "has edges without labels");
  if (claim == "state-labels")
    return some_state(automaton, "has labels on its edges, or none", [](const auto& state) {
      return state.labels == Labels::Edge || state.labels == Labels::Implied;
    });
  if (claim == "implicit-labels")
    return some_state(automaton, "has labels", [](const auto& state) {
      return state.labels == Labels::Edge || state.labels == Labels::State;
    });
  if (claim == "state-acc") return some_state(automaton, "has marks on an edge", marked_edge);
  if (claim == "trans-acc")
    return some_state(automaton, "has marks itself", [](const auto& state) { return !state.marks.empty(); });
  if (claim == "univ-branch") return not_branching(automaton);
  if (claim == "no-univ-branch")
    return universal_start(automaton) ? Refutation("the initial states are a conjunction")
                                      : some_state(automaton, "has a universal branch", branches);
  if (claim == "deterministic") return not_deterministic(automaton);
  if (claim == "complete") return not_complete(automaton);
  if (claim == "colored") return not_colored(automaton);
  if (claim == "weak") return not_weak(graph);
  if (claim == "very-weak") return not_very_weak(graph);
  if (claim == "terminal") return not_terminal(graph, automaton);
  return std::nullopt;
}

// parity: (lowest priority that counts first) p₀ ∘ (p₁ ∘ (…)), Inf with ∨ and Fin with ∧ in turn.
std::optional<HoaCondition> parity(bool max, bool odd, std::uint64_t colours) {
  HoaCondition out;
  if (colours == 0) return std::nullopt;
  for (std::uint64_t i = 0; i < colours; ++i) {  // from the colour that counts least
    const std::uint64_t colour = max ? i : colours - 1 - i;
    const bool good = (colour % 2 == 1) == odd;
    const HoaCondition self = leaf(good ? Op::Inf : Op::Fin, colour);
    out = i == 0 ? self : junction(good ? Op::Or : Op::And, {self, out});
  }
  return out;
}

// n sets, or n pairs of sets, joined.
HoaCondition row(Op outer, std::uint64_t n, const std::function<HoaCondition(std::uint64_t)>& each) {
  std::vector<HoaCondition> all;
  for (std::uint64_t i = 0; i < n; ++i) all.push_back(each(i));
  return junction(outer, std::move(all));
}

// Pair i is one Fin and counts[i] Infs, numbered on.
NamedCondition generalized_rabin(const std::vector<std::uint64_t>& counts) {
  NamedCondition out;
  out.condition.op = Op::Or;
  for (std::uint64_t count : counts) {
    std::vector<HoaCondition> pair{leaf(Op::Fin, out.sets++)};
    for (std::uint64_t i = 0; i < count; ++i) pair.push_back(leaf(Op::Inf, out.sets++));
    out.condition.operands.push_back(junction(Op::And, std::move(pair)));
  }
  return out;
}

std::optional<NamedCondition> parity_named(const std::vector<HoaToken>& name) {
  if (name.size() != 4 || name[3].kind != HoaToken::Kind::Integer || name[3].value > 64) return std::nullopt;
  const bool max = name[1].text == "max", odd = name[2].text == "odd";
  if ((!max && name[1].text != "min") || (!odd && name[2].text != "even")) return std::nullopt;
  // Without colours: t where the empty maximum counts as even (odd is what the others may not be), else f.
  if (name[3].value == 0) return NamedCondition{0, leaf(max == odd ? Op::True : Op::False, 0)};
  return NamedCondition{name[3].value, *parity(max, odd, name[3].value)};
}

}  // namespace

bool holds(const HoaCondition& condition, std::uint64_t infinitely_often) {
  const auto operand_holds = [&](const HoaCondition& c) { return holds(c, infinitely_often); };
  const auto& operands = condition.operands;
  switch (condition.op) {
    case Op::True: return true;
    case Op::False: return false;
    case Op::Inf: return ((infinitely_often >> condition.set) & 1U) != 0;
    case Op::Fin: return ((infinitely_often >> condition.set) & 1U) == 0;
    case Op::And: return std::all_of(operands.begin(), operands.end(), operand_holds);
    case Op::Or: return std::any_of(operands.begin(), operands.end(), operand_holds);
  }
  return false;  // unreachable: -Werror=switch
}

std::optional<NamedCondition> named_condition(const std::vector<HoaToken>& name) {
  const std::string_view kind = name.front().text;
  if (kind == "parity") return parity_named(name);
  std::vector<std::uint64_t> numbers;
  for (std::size_t i = 1; i < name.size(); ++i) {
    if (name[i].kind != HoaToken::Kind::Integer || name[i].value > 64) return std::nullopt;
    numbers.push_back(name[i].value);
  }
  const auto inf = [](std::uint64_t i) { return leaf(Op::Inf, i); };
  const auto fin = [](std::uint64_t i) { return leaf(Op::Fin, i); };
  const auto fin_and_inf = [](std::uint64_t i) {
    return junction(Op::And, {leaf(Op::Fin, 2 * i), leaf(Op::Inf, 2 * i + 1)});
  };
  const auto fin_or_inf = [](std::uint64_t i) {
    return junction(Op::Or, {leaf(Op::Fin, 2 * i), leaf(Op::Inf, 2 * i + 1)});
  };
  if (numbers.empty()) {
    if (kind == "all") return NamedCondition{0, leaf(Op::True, 0)};
    if (kind == "none") return NamedCondition{0, leaf(Op::False, 0)};
    if (kind == "Buchi") return NamedCondition{1, inf(0)};
    if (kind == "co-Buchi") return NamedCondition{1, fin(0)};
    return std::nullopt;
  }
  const std::uint64_t n = numbers[0];
  if (kind == "generalized-Rabin") {
    numbers.erase(numbers.begin());
    if (numbers.size() != n) return std::nullopt;
    return generalized_rabin(numbers);
  }
  if (numbers.size() != 1) return std::nullopt;
  if (kind == "generalized-Buchi") return NamedCondition{n, row(Op::And, n, inf)};
  if (kind == "generalized-co-Buchi") return NamedCondition{n, row(Op::Or, n, fin)};
  if (kind == "Rabin") return NamedCondition{2 * n, row(Op::Or, n, fin_and_inf)};
  if (kind == "Streett") return NamedCondition{2 * n, row(Op::And, n, fin_or_inf)};
  return std::nullopt;
}

std::vector<HoaContradiction> contradictions(HoaAutomaton& automaton) {
  std::vector<HoaContradiction> out;
  const HoaGraph graph(automaton);
  if (!automaton.acceptance_name.empty())
    if (Refutation reason = not_the_named_acceptance(automaton))
      out.push_back({automaton.acceptance_name.front(), std::move(*reason)});
  for (const HoaToken& claim : automaton.properties)
    if (Refutation reason = refute(claim.text, automaton, graph)) out.push_back({claim, std::move(*reason)});
  return out;
}

}  // namespace waymark::automata
