#include "libautomata/deterministic/to_parity.hpp"

#include <utility>

#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/deterministic/paritise.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/without_fin.hpp"

namespace waymark::automata {
namespace {

TransitionRelation deterministic_parity(const TransitionRelation& automaton, Budget& budget) {
  if (is_deterministic(automaton)) return paritise(trim(automaton), budget);
  return determinize(reduce(without_fin(automaton, budget), MarksOn::Edges, budget).automaton, budget);
}

}  // namespace

Dpa to_parity(const Automaton& automaton, Budget& budget) {
  const TransitionRelation parity =
      reduce_parity(deterministic_parity(automaton.transitions(), budget), budget).automaton;
  return *Dpa::checked(with_edges(automaton, plain_parity(parity)));
}

Deterministic determinized(const Automaton& automaton, Budget& budget) {
  if (std::optional<Deterministic> same = Deterministic::checked(automaton)) return *std::move(same);
  return *Deterministic::checked(to_parity(automaton, budget).automaton());
}

}  // namespace waymark::automata
