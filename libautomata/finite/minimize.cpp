#include "libautomata/finite/minimize.hpp"

#include <utility>

#include "libautomata/finite/refinement.hpp"
#include "libautomata/finite/very_weak.hpp"

namespace waymark::automata {
namespace {

Transitions quotient(const Transitions& automaton, const Partition& partition) {
  Transitions out;
  out.accepting.resize(partition.classes);
  for (std::uint32_t q = 0; q < partition.class_of.size(); ++q)
    out.accepting[partition.class_of[q]] = automaton.accepting[q];
  out.roots = out.diagram.import(
      partition.diagram, partition.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
      [](Mtbdd::Variable v) { return v; }, Mtbdd::Images::StayApart);
  out.initial = partition.class_of[automaton.initial];
  return out;
}

}  // namespace

Transitions minimize(const Transitions& automaton, Budget& budget) {
  const TransitionGraph graph(automaton.diagram, automaton.roots);
  const std::optional<Partition> partition = very_weak_partition(automaton, graph);
  return quotient(automaton, partition ? *partition : coarsest_partition(automaton, graph, budget));
}

Dfa as_dfa(Transitions automaton, const ltl::Vocabulary& vocabulary, const std::vector<ltl::Proposition>& reads) {
  std::vector<bool> asked(reads.size(), false);
  for (Mtbdd::Node n : automaton.diagram.reachable(automaton.roots)) asked[automaton.diagram.variable(n)] = true;
  std::vector<ltl::Proposition> kept;
  std::vector<Mtbdd::Variable> position(reads.size());
  for (std::size_t v = 0; v < reads.size(); ++v) {
    position[v] = static_cast<Mtbdd::Variable>(kept.size());
    if (asked[v]) kept.push_back(reads[v]);
  }
  if (kept.size() < reads.size()) {
    Mtbdd diagram;
    automaton.roots = diagram.import(
        automaton.diagram, automaton.roots, [](std::uint32_t q) { return Mtbdd::terminal(q); },
        [&](Mtbdd::Variable v) { return position[v]; }, Mtbdd::Images::StayApart);
    automaton.diagram = std::move(diagram);
  }
  return Dfa(vocabulary, std::move(kept), std::move(automaton.diagram), std::move(automaton.roots),
             std::move(automaton.accepting), StateId{automaton.initial});
}

Dfa minimize(const Dfa& dfa, Budget& budget) {
  Transitions automaton{dfa.diagram(), {}, {}, dfa.initial().index};
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    automaton.roots.push_back(dfa.root(StateId{q}));
    automaton.accepting.push_back(dfa.is_accepting(StateId{q}));
  }
  const Transitions minimal = minimize(canonical(automaton, budget), budget);
  return as_dfa(canonical(minimal, budget), dfa.vocabulary(), dfa.reads());
}

}  // namespace waymark::automata
