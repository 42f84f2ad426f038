// A candidate is one of several automata of the same formula; the smallest candidate is kept.
#pragma once
#include <optional>

#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Candidate {
  TransitionRelation automaton;  // of the formula
  bool reduced = true;           // false: a reduction ran out of budget
  bool weak = false;             // a minimal weak deterministic automaton: marks are on states already
};

// Fewer states, or as many and fewer edges.
inline bool smaller(const TransitionRelation& a, const TransitionRelation& b) {
  return a.states() < b.states() || (a.states() == b.states() && count_edges(a) < count_edges(b));
}
// The first one unless the second is smaller.
inline std::optional<Candidate> smallest(std::optional<Candidate> a, std::optional<Candidate> b) {
  if (!a || (b && smaller(b->automaton, a->automaton))) return b;
  return a;
}

}  // namespace waymark::automata
