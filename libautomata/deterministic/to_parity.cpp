#include "libautomata/deterministic/to_parity.hpp"

#include <utility>

#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/deterministic/paritise.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/without_fin.hpp"

namespace waymark::automata {
namespace {

Branching deterministic_parity(const Branching& automaton, Effort& effort) {
  if (is_deterministic(automaton)) return paritise(trim(automaton), effort);
  return determinize(reduce(without_fin(automaton, effort), MarksOn::Edges, effort).automaton, effort);
}

}  // namespace

Dpa to_parity(const Automaton& automaton, Effort& effort) {
  const Branching parity =
      reduce_parity(deterministic_parity(automaton.transitions(), effort), effort).automaton;
  return *Dpa::checked(as_automaton(plain_parity(parity), automaton.vocabulary(), automaton.reads()));
}

Deterministic determinized(const Automaton& automaton, Effort& effort) {
  if (std::optional<Deterministic> same = Deterministic::checked(automaton)) return *std::move(same);
  return *Deterministic::checked(to_parity(automaton, effort).automaton());
}

}  // namespace waymark::automata
