#include "libplan/learn/task_rows.hpp"

namespace waymark::plan {

TaskRows tabulate(const automata::Dfa& dfa, const Letters& letters) {
  TaskRows table;
  table.classes = AlphabetClasses(letters, dfa.vocabulary(), dfa.reads(), UnknownProposition::Refuse);
  table.tasks = static_cast<std::uint32_t>(dfa.states());
  table.letters = static_cast<std::uint32_t>(table.classes.size());
  table.initial = dfa.initial().index;
  for (std::uint32_t q = 0; q < table.tasks; ++q) {
    const automata::StateId state{q};
    for (const ltl::Letter& letter : table.classes.representatives())
      table.next.push_back(dfa.next(state, letter).index);
    table.ending.push_back(dfa.is_accepting(state) ? Ending::Accepting
                           : dfa.is_trap(state)    ? Ending::Trap
                                                   : Ending::Open);
    table.distance.push_back(dfa.distance_to_acceptance(state));
  }
  return table;
}

}  // namespace waymark::plan
