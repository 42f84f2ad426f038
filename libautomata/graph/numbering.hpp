// Numbering numbers the states of an automaton under construction in the order of their first occurrence. The list of
// states serves as the queue of the exploration. NumberedPairs is faster for pairs of numbers.
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
