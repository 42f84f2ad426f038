#include "libautomata/omega/reduce.hpp"

#include "libautomata/omega/simulation.hpp"

namespace waymark::automata {
namespace {

std::vector<bool> colours(const Branching& automaton, MarksOn marks) {
  std::vector<bool> out(automaton.states(), false);
  if (marks == MarksOn::Edges) return out;
  ChoiceLists lists(automaton);
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const Branch& b : lists.branches(q)) out[q] = out[q] || !b.marks.empty();
  return out;
}

}  // namespace

Reduced reduce(Branching automaton, MarksOn marks, Effort& effort) {
  const auto filter = [&](const Branching& a) { return scc_filter(a, marks, effort); };
  Effort unlimited;  // trimmed in any case, in linear time
  automaton = scc_filter(automaton, marks, unlimited);
  try {
    automaton = bisimulation_quotient(automaton, effort);
    while (true) {
      const auto size = std::pair(automaton.states(), count_edges(automaton));
      automaton = filter(simulation_quotient(automaton, effort));
      automaton = filter(reverse_simulation_quotient(automaton, colours(automaton, marks), effort));
      if (std::pair(automaton.states(), count_edges(automaton)) == size) return {std::move(automaton), true};
    }
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    return {std::move(automaton), false};
  }
}

}  // namespace waymark::automata
