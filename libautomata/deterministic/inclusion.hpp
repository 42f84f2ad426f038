// Language inclusion between the states of two deterministic automata.
//
// A word that one state accepts and the other rejects is a run of pairs that satisfies the first condition and not the
// second. The graph of all pairs is built once, and its live part decides every pair of states. [BK08, Sec. 4.4.2]
#pragma once
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

// [q][r]: L(q) ⊆ L(r), q a state of a, r one of b. Both deterministic and complete, over the same variables, any
// acceptance. One step of budget per pair of nodes; more than Marks::most sets in both count as too many states.
std::vector<std::vector<bool>> inclusions(const TransitionRelation& a, const TransitionRelation& b, Budget& budget);

}  // namespace waymark::automata
