#include "libautomata/finite/guard.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_set>
#include <utility>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// A cover of some function between `lower` and `upper`, and that function. [Min93, Fig. 2]
class Cover {
 public:
  struct TooLong {};  // thrown
  Cover(Mtbdd& diagram, Boolean& logic, std::size_t most_cubes)
      : diagram_(diagram), logic_(logic), most_cubes_(most_cubes) {}

  Node between(Node lower, Node upper) {
    if (lower == Boolean::constant(false)) return lower;
    if (upper == Boolean::constant(true)) {
      keep_path();
      return upper;
    }
    const Mtbdd::Variable v = std::min(diagram_.variable(lower), diagram_.variable(upper));
    const auto [lower0, lower1] = cofactors(lower, v);
    const auto [upper0, upper1] = cofactors(upper, v);
    const Node low = under({v, false}, logic_.conjunction(lower0, logic_.negate(upper1)), upper0);
    const Node high = under({v, true}, logic_.conjunction(lower1, logic_.negate(upper0)), upper1);
    const Node rest1 = logic_.conjunction(lower1, logic_.negate(high));
    const Node rest0 = logic_.conjunction(lower0, logic_.negate(low));
    const Node rest = logic_.disjunction(rest0, rest1);
    const Node both = between(rest, logic_.conjunction(upper0, upper1));
    return logic_.disjunction(logic_.if_then_else(logic_.variable(v), high, low), both);
  }

  Guard cubes() && { return std::move(cubes_); }

 private:
  [[gnu::noinline]] void keep_path() {  // out of the recursion's frames
    if (cubes_.size() == most_cubes_) throw TooLong{};
    cubes_.push_back(path_);
  }
  std::pair<Node, Node> cofactors(Node f, Mtbdd::Variable v) const {
    return diagram_.variable(f) == v ? std::pair(diagram_.low(f), diagram_.high(f)) : std::pair(f, f);
  }
  Node under(Literal literal, Node lower, Node upper) {
    path_.push_back(literal);
    const Node covered = between(lower, upper);
    path_.pop_back();
    return covered;
  }

  Mtbdd& diagram_;
  Boolean& logic_;
  std::size_t most_cubes_;
  Cube path_;
  Guard cubes_;
};

// Literals and negation signs.
std::size_t length(const Guard& guard) {
  std::size_t sum = 0;
  for (const Cube& cube : guard)
    for (const Literal& literal : cube) sum += literal.positive ? 1 : 2;
  return sum;
}

}  // namespace

Guard irredundant_cover(Mtbdd& diagram, Boolean& logic, Node f) {
  return *irredundant_cover(diagram, logic, f, SIZE_MAX);
}

std::optional<Guard> irredundant_cover(Mtbdd& diagram, Boolean& logic, Node f, std::size_t most_cubes) {
  Cover cover(diagram, logic, most_cubes);
  try {
    cover.between(f, f);
  } catch (const Cover::TooLong&) {
    return std::nullopt;
  }
  return std::move(cover).cubes();
}

Edges::Edges(const Dfa& dfa) : dfa_(dfa), scratch_(dfa.diagram()), logic_(scratch_) {
  is_target_.reserve(dfa.states());
  for (std::size_t q = 0; q < dfa.states(); ++q) is_target_.push_back(scratch_.operation());
}

Node Edges::leads_to(StateId q, StateId r) {
  const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
    if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
    return Boolean::constant(Mtbdd::payload(n[0]) == r.index);
  };
  return scratch_.apply(is_target_[r.index], std::array{dfa_.root(q)}, decide);
}

std::vector<Edge> Edges::from(StateId q) { return *from(q, SIZE_MAX); }

std::optional<std::vector<Edge>> Edges::from(StateId q, std::size_t most_cubes) {
  std::vector<Edge> out;
  for (StateId r : targets(dfa_, q)) {
    std::optional<Guard> guard = irredundant_cover(scratch_, logic_, leads_to(q, r), most_cubes);
    if (!guard) return std::nullopt;
    out.push_back({q, r, std::move(*guard)});
  }
  return out;
}

ltl::Formula Edges::label(StateId q, StateId r, ltl::Arena& arena) {
  const Node f = leads_to(q, r);
  const Guard positive = irredundant_cover(scratch_, logic_, f);
  const Guard negative = irredundant_cover(scratch_, logic_, logic_.negate(f));
  if (length(positive) <= length(negative) + 1) return to_formula(positive, dfa_, arena);
  return ltl::negate(to_formula(negative, dfa_, arena));
}

std::vector<StateId> targets(const Dfa& dfa, StateId q) {
  std::vector<StateId> out;
  std::unordered_set<std::uint32_t> seen;  // ids of nodes and terminals
  std::vector<Node> stack{dfa.root(q)};
  while (!stack.empty()) {
    const Node n = stack.back();
    stack.pop_back();
    if (!seen.insert(n.id).second) continue;
    if (Mtbdd::is_terminal(n)) {
      out.push_back(StateId{Mtbdd::payload(n)});
    } else {
      stack.push_back(dfa.diagram().high(n));
      stack.push_back(dfa.diagram().low(n));
    }
  }
  return out;
}

std::size_t count_edges(const Dfa& dfa) { return *count_edges(dfa, SIZE_MAX); }

std::optional<std::size_t> count_edges(const Dfa& dfa, std::size_t most) {
  constexpr std::uint32_t never = UINT32_MAX;
  std::vector<std::uint32_t> node_seen(dfa.diagram().size(), never), state_seen(dfa.states(), never);  // last from
  std::vector<Node> stack;
  std::size_t sum = 0;
  for (std::uint32_t q = 0; q < dfa.states() && sum <= most; ++q) {
    stack.push_back(dfa.root(StateId{q}));
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      if (Mtbdd::is_terminal(n)) {
        if (std::exchange(state_seen[Mtbdd::payload(n)], q) != q) ++sum;
      } else if (std::exchange(node_seen[n.id], q) != q) {
        stack.push_back(dfa.diagram().high(n));
        stack.push_back(dfa.diagram().low(n));
      }
    }
  }
  return sum <= most ? std::optional(sum) : std::nullopt;
}

std::size_t count_nodes(const Dfa& dfa) {
  std::vector<Node> roots;
  for (std::uint32_t q = 0; q < dfa.states(); ++q) roots.push_back(dfa.root(StateId{q}));
  return dfa.diagram().reachable(roots).size();
}

ltl::Formula to_formula(const Guard& guard, const Dfa& dfa, ltl::Arena& arena) {
  for (ltl::Proposition p : dfa.reads()) arena.atom(dfa.vocabulary().name(p));
  std::vector<ltl::Formula> cubes;
  for (const Cube& cube : guard) {
    std::vector<ltl::Formula> conjuncts;
    for (const Literal& literal : cube) {
      const ltl::Formula atom = arena.atom(dfa.vocabulary().name(dfa.reads()[literal.variable]));
      conjuncts.push_back(literal.positive ? atom : ltl::negate(atom));
    }
    cubes.push_back(ltl::conjunction(arena, conjuncts));
  }
  return ltl::disjunction(arena, cubes);
}

}  // namespace waymark::automata
