// The classes come from refining one proposition at a time: two letters stay together as long as the automaton's
// propositions so far agree on them. No hashing, any number of propositions, classes in order of first occurrence.
#include "libplan/product/task_steps.hpp"

#include <algorithm>
#include <array>

#include "libplan/world/trajectory.hpp"

namespace waymark::plan {

using automata::Dfa;
using automata::StateId;

TaskSteps::TaskSteps(const Map& map, const Dfa& dfa)
    : map_(&map), dfa_(&dfa), class_(map.letters().size(), 0), rows_(dfa.states(), not_visited) {
  representatives_.emplace_back();
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::array<std::uint32_t, 2>> refined;  // class so far × (in the letter or not) → class
  for (ltl::Proposition p : dfa.reads()) {
    const auto ours = map.vocabulary().find(dfa.vocabulary().name(p));
    if (!ours) throw unknown_proposition(map, dfa.vocabulary().name(p));
    refined.assign(representatives_.size(), {none, none});
    std::vector<ltl::Letter> representatives;
    for (std::size_t i = 0; i < class_.size(); ++i) {
      const bool carried = map.letters()[i].contains(*ours);
      std::uint32_t& target = refined[class_[i]][carried ? 1 : 0];
      if (target == none) {
        target = static_cast<std::uint32_t>(representatives.size());
        representatives.push_back(representatives_[class_[i]]);
        if (carried) representatives.back().insert(p);
      }
      class_[i] = target;
    }
    representatives_ = std::move(representatives);
  }
}

void TaskSteps::visit(StateId q) {
  rows_[q.index] = targets_.size();
  for (const ltl::Letter& letter : representatives_) targets_.push_back(dfa_->next(q, letter));
}

}  // namespace waymark::plan
