// States of an automaton that is being made, numbered in the order in which they are met; the list of them doubles as
// the queue of those to be looked at. Pairs of numbers are numbered faster by NumberedPairs.
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "libautomata/budget.hpp"

namespace waymark::automata {

template <class State>
class Numbering {
 public:
  // One state of budget for each that is new.
  std::uint32_t of(State state, Budget& budget) {
    const auto [at, fresh] = number_.try_emplace(std::move(state), static_cast<std::uint32_t>(list_.size()));
    if (fresh) {
      budget.state();
      list_.push_back(&at->first);
    }
    return at->second;
  }
  std::size_t size() const { return list_.size(); }
  const State& operator[](std::size_t number) const { return *list_[number]; }  // stays where it is

 private:
  std::map<State, std::uint32_t> number_;
  std::vector<const State*> list_;
};

}  // namespace waymark::automata
