// The synchronous product of two ω-automata over the same variables. Its runs are pairs of runs on one word.
#pragma once
#include <utility>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Pairs {
  TransitionRelation automaton;                                // of both
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // by state: those of a and b
};

// L(a) ∩ L(b): reachable pairs, the marks of b after those of a, the conditions joined by ∧. One state of budget per
// pair; more than Marks::most sets count as too many states.
Pairs pairs_of(const TransitionRelation& a, const TransitionRelation& b, Budget& budget);
TransitionRelation intersection(const TransitionRelation& a, const TransitionRelation& b, Budget& budget);

}  // namespace waymark::automata
