#include "libautomata/deterministic/conversions.hpp"

#include <optional>

#include "libautomata/deterministic/parity.hpp"
#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/without_fin.hpp"

namespace waymark::automata {

Automaton to_tgba(const Automaton& automaton, Budget& budget) {
  return with_edges(automaton, reduce(without_fin(automaton.transitions(), budget), MarksOn::Edges, budget).automaton);
}

Automaton to_rabin(const Automaton& automaton, Budget& budget) {
  const Automaton parity = to_parity(automaton, budget).automaton();
  return with_edges(parity, as_rabin(min_even_parity(parity.transitions())));
}

Automaton to_generic(const Automaton& automaton, Budget& budget) {
  const Automaton parity = to_parity(automaton, budget).automaton();
  const auto own = Deterministic::checked(automaton);
  return own && own->automaton().states() < parity.states() ? own->automaton() : parity;
}

}  // namespace waymark::automata
