#include "libautomata/finite/dfa.hpp"

#include <stdexcept>

#include "libautomata/bdd/transitions.hpp"

namespace waymark::automata {
namespace {

// Fewest letters to an accepting state, backwards over the shared graph: the edge from a state to its root costs one
// letter, all others nothing.
std::vector<std::uint32_t> distances(const TransitionGraph& graph, const std::vector<bool>& accepting) {
  const ReversedGraph reversed(graph);
  std::vector<std::uint32_t> distance(graph.size(), Dfa::unreachable);
  std::vector<Vertex> layer, next_layer;  // vertices at the current distance; at one letter more
  for (std::uint32_t q = 0; q < accepting.size(); ++q) {
    if (!accepting[q]) continue;
    distance[graph.of_state(q)] = 0;
    layer.push_back(graph.of_state(q));
  }
  for (std::uint32_t d = 0; !layer.empty(); ++d, layer.swap(next_layer), next_layer.clear()) {
    while (!layer.empty()) {
      const Vertex v = layer.back();
      layer.pop_back();
      for (Vertex u : reversed.predecessors(v)) {
        if (distance[u] != Dfa::unreachable) continue;
        distance[u] = graph.is_state(u) ? d + 1 : d;
        (graph.is_state(u) ? next_layer : layer).push_back(u);
      }
    }
  }
  return {distance.begin() + graph.of_state(0), distance.end()};
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

Dfa::Dfa(ltl::Vocabulary vocabulary, std::vector<ltl::Proposition> reads, Mtbdd diagram, std::vector<Mtbdd::Node> roots,
         std::vector<bool> accepting, StateId initial)
    : vocabulary_(std::move(vocabulary)),
      reads_(std::move(reads)),
      diagram_(std::move(diagram)),
      roots_(std::move(roots)),
      accepting_(std::move(accepting)),
      initial_(initial) {
  require(roots_.size() == accepting_.size(), "a DFA needs one acceptance bit per state");
  require(initial_.index < roots_.size(), "the initial state of a DFA must be one of its states");
  require(!accepting_[initial_.index], "the initial state of a DFA must reject the empty word");
  for (ltl::Proposition p : reads_) require(p.index < vocabulary_.size(), "a DFA reads an unknown proposition");
  const TransitionGraph graph(diagram_, roots_);
  for (Vertex v = 0; v < graph.size(); ++v) {
    for (const Vertex w : graph.successors(v)) require(w < graph.size(), "a DFA edge leads to no state");
    require(graph.is_state(v) || diagram_.variable(graph.node(v)) < reads_.size(),
            "a DFA edge asks for a proposition that is not read");
  }
  distance_ = distances(graph, accepting_);
}

void Dfa::rename(ltl::Vocabulary names) {
  for (ltl::Proposition p : reads_) require(p.index < names.size(), "a proposition that a DFA reads has no new name");
  vocabulary_ = std::move(names);
}

StateId Dfa::next(StateId q, const ltl::Letter& letter) const {
  const auto holds = [&](Mtbdd::Variable v) { return letter.contains(reads_[v]); };
  return StateId{Mtbdd::payload(diagram_.evaluate(roots_[q.index], holds))};
}

bool accepts(const Dfa& dfa, const ltl::Trace& word) {
  StateId q = dfa.initial();
  for (const ltl::Letter& letter : word) q = dfa.next(q, letter);
  return dfa.is_accepting(q);
}

}  // namespace waymark::automata
