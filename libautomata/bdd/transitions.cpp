#include "libautomata/bdd/transitions.hpp"

#include <utility>

namespace waymark::automata {
namespace {

// One root after the other, each depth first with the low side first: states get their numbers on the way down, nodes
// on the way up, so both depend on the functions alone. Numbers are one to one: different nodes stay different.
class CanonicalCopy {
 public:
  CanonicalCopy(const Transitions& from, Budget& budget)
      : from_(from), budget_(budget), image_(from.diagram.size()), number_(from.roots.size(), unseen) {}

  Transitions run() && {
    state(from_.initial);
    for (std::size_t i = 0; i < order_.size(); ++i) {  // the order doubles as the queue
      budget_.step();
      out_.roots.push_back(copy(from_.roots[order_[i]]));
      out_.accepting.push_back(from_.accepting[order_[i]]);
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t unseen = UINT32_MAX;

  Mtbdd::Node state(std::uint32_t q) {
    if (number_[q] == unseen) {
      number_[q] = static_cast<std::uint32_t>(order_.size());
      order_.push_back(q);
    }
    return Mtbdd::terminal(number_[q]);
  }
  Mtbdd::Node copy(Mtbdd::Node n) {
    if (Mtbdd::is_terminal(n)) return state(Mtbdd::payload(n));
    if (!Mtbdd::is_terminal(image_[n.id])) return image_[n.id];
    const Mtbdd::Node low = copy(from_.diagram.low(n));
    const Mtbdd::Node high = copy(from_.diagram.high(n));
    return image_[n.id] = out_.diagram.append(from_.diagram.variable(n), low, high);
  }

  const Transitions& from_;
  Budget& budget_;
  std::vector<Mtbdd::Node> image_;     // a terminal: not copied yet
  std::vector<std::uint32_t> number_;  // of a state, `unseen` before it is reached
  std::vector<std::uint32_t> order_;   // states by number
  Transitions out_;
};

}  // namespace

TransitionGraph::TransitionGraph(const Mtbdd& diagram, std::span<const Mtbdd::Node> roots)
    : nodes_(diagram.reachable(roots)) {
  std::vector<Vertex> rank(diagram.size());
  const auto vertex = [&](Mtbdd::Node n) { return Mtbdd::is_terminal(n) ? of_state(Mtbdd::payload(n)) : rank[n.id]; };
  targets_.reserve(2 * nodes_.size() + roots.size());
  for (Vertex v = 0; v < nodes_.size(); ++v) {
    rank[nodes_[v].id] = v;
    targets_.push_back(vertex(diagram.low(nodes_[v])));
    targets_.push_back(vertex(diagram.high(nodes_[v])));
  }
  for (Mtbdd::Node root : roots) targets_.push_back(vertex(root));
}

ReversedGraph::ReversedGraph(const TransitionGraph& graph) : begin_(graph.size() + 1, 0) {
  for (Vertex v = 0; v < graph.size(); ++v)
    for (Vertex w : graph.successors(v)) ++begin_[w + 1];
  for (std::size_t v = 0; v < graph.size(); ++v) begin_[v + 1] += begin_[v];
  sources_.resize(begin_.back());
  std::vector<std::uint32_t> fill(begin_.begin(), begin_.end() - 1);
  for (Vertex v = 0; v < graph.size(); ++v)
    for (Vertex w : graph.successors(v)) sources_[fill[w]++] = v;
}

Transitions canonical(const Transitions& automaton, Budget& budget) { return CanonicalCopy(automaton, budget).run(); }

}  // namespace waymark::automata
