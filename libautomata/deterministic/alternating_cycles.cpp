#include "libautomata/deterministic/alternating_cycles.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace waymark::automata {
namespace {

using Edges = std::vector<std::uint32_t>;

struct EdgeList {
  const std::vector<std::uint32_t>& source;
  const std::vector<Branch>& branch;
};

// The strongly connected sets of edges that these ones fall into, each ascending.
std::vector<Edges> connected(const EdgeList& list, const Edges& edges) {
  std::vector<std::uint32_t> states;
  for (std::uint32_t e : edges) {
    states.push_back(list.source[e]);
    states.push_back(list.branch[e].target);
  }
  std::sort(states.begin(), states.end());
  states.erase(std::unique(states.begin(), states.end()), states.end());
  const auto number = [&](std::uint32_t q) {
    return static_cast<std::uint32_t>(std::lower_bound(states.begin(), states.end(), q) - states.begin());
  };
  BranchGraph part;
  for (std::size_t i = 0; i < states.size(); ++i) part.add_state();
  for (std::uint32_t e : edges) part.add(number(list.source[e]), {number(list.branch[e].target), {}});
  const Components found = components(part);
  std::vector<Edges> all(found.count);
  for (std::uint32_t e : edges) {
    const std::uint32_t c = found.of[number(list.source[e])];
    if (c == found.of[number(list.branch[e].target)]) all[c].push_back(e);
  }
  all.erase(std::remove_if(all.begin(), all.end(), [](const Edges& one) { return one.empty(); }), all.end());
  return all;
}

// The largest strongly connected subsets of edges whose marks satisfy a condition.
class LargestCycles {
 public:
  LargestCycles(const EdgeList& list, Budget& budget) : list_(list), budget_(budget) {}

  std::vector<Edges> run(const Edges& edges, const Condition& condition) {
    search(edges, condition);
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  void search(const Edges& edges, const Condition& condition) {
    budget_.step(edges.size() + 1);
    for (const Edges& one : connected(list_, edges)) {
      if (std::any_of(found_.begin(), found_.end(), [&](const Edges& known) { return within(one, known); })) continue;
      Marks met;
      for (std::uint32_t e : one) met = met | list_.branch[e].marks;
      Condition rest = condition;
      for (std::uint32_t mark : condition.marks().without(met).members()) rest = rest.replaced(mark, false);
      if (rest.holds(met)) {
        keep(one);
      } else if (rest.op() == Condition::Op::Or) {
        for (const Condition& operand : rest.operands()) search(one, operand);
      } else {
        const auto marks = in_the_way(rest, met);
        for (std::uint32_t mark : *marks) search(avoiding(one, mark), rest.replaced(mark, false));
      }
    }
  }
  // Of an unsatisfied condition: marks one of which every cycle that satisfies it avoids. Inf of what is met holds, of
  // what is not met has been replaced. nullopt when it is satisfied.
  static std::optional<std::vector<std::uint32_t>> in_the_way(const Condition& condition, Marks met) {
    if (condition.holds(met)) return std::nullopt;
    if (condition.op() == Condition::Op::Fin) return std::vector<std::uint32_t>{condition.mark()};
    std::optional<std::vector<std::uint32_t>> out;
    for (const Condition& operand : condition.operands()) {
      auto marks = in_the_way(operand, met);
      if (!marks) continue;
      if (!out || (condition.op() == Condition::Op::And && marks->size() < out->size()))
        out = std::move(marks);
      else if (condition.op() == Condition::Op::Or)
        out->insert(out->end(), marks->begin(), marks->end());
    }
    return out ? out : std::vector<std::uint32_t>{};
  }
  Edges avoiding(const Edges& edges, std::uint32_t mark) const {
    Edges out;
    for (std::uint32_t e : edges)
      if (!list_.branch[e].marks.contains(mark)) out.push_back(e);
    return out;
  }
  static bool within(const Edges& inner, const Edges& outer) {
    return std::includes(outer.begin(), outer.end(), inner.begin(), inner.end());
  }
  void keep(const Edges& edges) {
    found_.erase(std::remove_if(found_.begin(), found_.end(), [&](const Edges& e) { return within(e, edges); }),
                 found_.end());
    found_.push_back(edges);
  }

  EdgeList list_;
  Budget& budget_;
  std::vector<Edges> found_;
};

}  // namespace

AlternatingCycles::AlternatingCycles(const TransitionRelation& automaton, Budget& budget)
    : graph_(automaton), root_(automaton.states(), none) {
  for (std::uint32_t q = 0; q < graph_.size(); ++q) {
    first_edge_.push_back(static_cast<std::uint32_t>(branch_.size()));
    for (const Branch& b : graph_.branches(q)) {
      branch_.push_back(b);
      source_.push_back(q);
    }
  }
  Edges all(branch_.size());
  std::iota(all.begin(), all.end(), 0U);
  const Condition& condition = automaton.acceptance.condition;
  for (Edges& edges : connected({source_, branch_}, all)) {
    Marks met;
    for (std::uint32_t e : edges) met = met | branch_[e].marks;
    const bool accepting = condition.holds(met);
    const Node root = add(std::move(edges), none, accepting ? 0 : 1, accepting);
    for (std::uint32_t q : nodes_[root].states) root_[q] = root;
    for (Node node = root; node < nodes_.size(); ++node) grow(node, condition, budget);  // they double as queue
  }
}

AlternatingCycles::Node AlternatingCycles::add(Edges edges, Node parent, std::uint32_t colour, bool accepting) {
  if (colour + 2 > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  Cycle made;
  made.parent = parent;
  made.colour = colour;
  made.accepting = accepting;
  for (std::uint32_t e : edges) made.states.push_back(source_[e]);
  made.states.erase(std::unique(made.states.begin(), made.states.end()), made.states.end());
  made.edges = std::move(edges);
  colours_ = std::max(colours_, colour + 1);
  nodes_.push_back(std::move(made));
  return static_cast<Node>(nodes_.size() - 1);
}

void AlternatingCycles::grow(Node node, const Condition& condition, Budget& budget) {
  budget.state();
  const bool accepting = nodes_[node].accepting;
  const Condition other = accepting ? condition.negated() : condition;
  std::vector<Edges> inside = LargestCycles({source_, branch_}, budget).run(nodes_[node].edges, other);
  for (Edges& edges : inside) {
    const Node child = add(std::move(edges), node, nodes_[node].colour + 1, !accepting);
    nodes_[node].children.push_back(child);
  }
}

bool AlternatingCycles::has(Node node, std::uint32_t q) const {
  return std::binary_search(nodes_[node].states.begin(), nodes_[node].states.end(), q);
}

AlternatingCycles::Node AlternatingCycles::descend(Node node, std::uint32_t q) const {
  for (;;) {
    const std::vector<Node>& children = nodes_[node].children;
    const auto next = std::find_if(children.begin(), children.end(), [&](Node c) { return has(c, q); });
    if (next == children.end()) return node;
    node = *next;
  }
}

AlternatingCycles::Node AlternatingCycles::entry(std::uint32_t q) const {
  return root_[q] == none ? none : descend(root_[q], q);
}

AlternatingCycles::Transition AlternatingCycles::step(std::uint32_t q, Node at, const Branch& branch) const {
  if (at == none || root_[branch.target] != root_[q]) return {entry(branch.target), no_colour};
  const auto& own = graph_.branches(q);
  const auto edge =
      first_edge_[q] + static_cast<std::uint32_t>(std::lower_bound(own.begin(), own.end(), branch) - own.begin());
  Node node = at, left = none;
  while (!std::binary_search(nodes_[node].edges.begin(), nodes_[node].edges.end(), edge)) {
    left = node;
    node = nodes_[node].parent;
  }
  const Cycle& cycle = nodes_[node];
  if (left == none) return {descend(node, branch.target), cycle.colour};
  const auto after = std::find(cycle.children.begin(), cycle.children.end(), left) - cycle.children.begin();
  const std::size_t count = cycle.children.size();
  for (std::size_t i = 1; i <= count; ++i) {
    const Node child = cycle.children[(static_cast<std::size_t>(after) + i) % count];
    if (has(child, branch.target)) return {descend(child, branch.target), cycle.colour};
  }
  return {node, cycle.colour};
}

}  // namespace waymark::automata
