#include "libautomata/transitions.hpp"

namespace waymark::automata {
namespace {

constexpr std::uint32_t unseen = UINT32_MAX;

struct Numbering {
  std::vector<std::uint32_t> order;   // old states in their new order
  std::vector<std::uint32_t> number;  // new number of an old state, `unseen` when unreachable
};

Numbering breadth_first(const Transitions& automaton) {
  const Mtbdd& diagram = automaton.diagram;
  Numbering out{{automaton.initial}, std::vector<std::uint32_t>(automaton.roots.size(), unseen)};
  out.number[automaton.initial] = 0;
  std::vector<bool> visited(diagram.size(), false);  // below a visited node every state is numbered already
  std::vector<Mtbdd::Node> stack;
  for (std::size_t i = 0; i < out.order.size(); ++i) {  // the order doubles as the queue
    stack.push_back(automaton.roots[out.order[i]]);
    while (!stack.empty()) {
      const Mtbdd::Node n = stack.back();
      stack.pop_back();
      if (Mtbdd::is_terminal(n)) {
        std::uint32_t& number = out.number[Mtbdd::payload(n)];
        if (number != unseen) continue;
        number = static_cast<std::uint32_t>(out.order.size());
        out.order.push_back(Mtbdd::payload(n));
      } else if (!visited[n.id]) {
        visited[n.id] = true;
        stack.push_back(diagram.high(n));
        stack.push_back(diagram.low(n));
      }
    }
  }
  return out;
}

// Copies one root at a time, children first and the low side first: node ids depend on the functions alone. Numbers
// are one to one, so different nodes stay different.
class CanonicalCopy {
 public:
  CanonicalCopy(const Mtbdd& from, const Numbering& numbering, Mtbdd& to)
      : from_(from), numbering_(numbering), to_(to), image_(from.size()), done_(from.size(), false) {}

  Mtbdd::Node copy(Mtbdd::Node root) {
    std::vector<Mtbdd::Node> stack{root};
    while (!stack.empty()) {
      const Mtbdd::Node n = stack.back();
      if (ready(n)) {
        stack.pop_back();
      } else if (!ready(from_.low(n))) {
        stack.push_back(from_.low(n));
      } else if (!ready(from_.high(n))) {
        stack.push_back(from_.high(n));
      } else {
        image_[n.id] = to_.append(from_.variable(n), image(from_.low(n)), image(from_.high(n)));
        done_[n.id] = true;
      }
    }
    return image(root);
  }

 private:
  bool ready(Mtbdd::Node n) const { return Mtbdd::is_terminal(n) || done_[n.id]; }
  Mtbdd::Node image(Mtbdd::Node n) const {
    return Mtbdd::is_terminal(n) ? Mtbdd::terminal(numbering_.number[Mtbdd::payload(n)]) : image_[n.id];
  }

  const Mtbdd& from_;
  const Numbering& numbering_;
  Mtbdd& to_;
  std::vector<Mtbdd::Node> image_;
  std::vector<bool> done_;
};

}  // namespace

TransitionGraph::TransitionGraph(const Mtbdd& diagram, std::span<const Mtbdd::Node> roots)
    : nodes_(diagram.reachable(roots)) {
  std::vector<Vertex> rank(diagram.size());
  const auto vertex = [&](Mtbdd::Node n) {
    return Mtbdd::is_terminal(n) ? of_state(Mtbdd::payload(n)) : rank[n.id];
  };
  targets_.reserve(2 * nodes_.size() + roots.size());
  for (Vertex v = 0; v < nodes_.size(); ++v) {
    rank[nodes_[v].id] = v;
    targets_.push_back(vertex(diagram.low(nodes_[v])));
    targets_.push_back(vertex(diagram.high(nodes_[v])));
  }
  for (Mtbdd::Node root : roots) targets_.push_back(vertex(root));
}

ReversedGraph::ReversedGraph(const TransitionGraph& graph) : begin_(graph.size() + 1, 0) {
  using Vertex = TransitionGraph::Vertex;
  for (Vertex v = 0; v < graph.size(); ++v)
    for (Vertex w : graph.successors(v)) ++begin_[w + 1];
  for (std::size_t v = 0; v < graph.size(); ++v) begin_[v + 1] += begin_[v];
  sources_.resize(begin_.back());
  std::vector<std::uint32_t> fill(begin_.begin(), begin_.end() - 1);
  for (Vertex v = 0; v < graph.size(); ++v)
    for (Vertex w : graph.successors(v)) sources_[fill[w]++] = v;
}

Transitions canonical(const Transitions& automaton) {
  const Numbering numbering = breadth_first(automaton);
  Transitions out;
  CanonicalCopy copier(automaton.diagram, numbering, out.diagram);
  for (std::uint32_t q : numbering.order) {
    out.roots.push_back(copier.copy(automaton.roots[q]));
    out.accepting.push_back(automaton.accepting[q]);
  }
  return out;
}

}  // namespace waymark::automata
