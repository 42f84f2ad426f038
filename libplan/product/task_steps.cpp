#include "libplan/product/task_steps.hpp"

namespace waymark::plan {

TaskSteps::TaskSteps(const Map& map, const automata::Dfa& dfa, Traps traps)
    : map_(&map),
      dfa_(&dfa),
      traps_(traps),
      classes_(map.letters(), dfa.vocabulary(), dfa.reads(), UnknownProposition::Refuse, "the map " + map.name()),
      rows_(dfa.states(), not_visited) {}

void TaskSteps::visit(automata::StateId q) const {
  rows_[q.index] = targets_.size();
  for (const ltl::Letter& letter : classes_.representatives()) targets_.push_back(dfa_->next(q, letter));
}

}  // namespace waymark::plan
