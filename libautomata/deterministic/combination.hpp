// Boolean combinations of languages that have deterministic automata: their product, with a condition that says the
// combination.
//
// A part is followed only as long as its answer matters: where it is settled, or where what is settled of the others
// decides without it, it goes. A part that speaks of the far end of words only waits until a component of the product
// of the others is reached in which the answer depends on it, and starts afresh there ([BBDLF13, Sec. 3] for
// conjunctions). The conditions are not degeneralised: paritise() takes what comes out.
#pragma once
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Part {
  TransitionRelation automaton;  // deterministic, any condition
  bool late = false;             // it accepts uv exactly when it accepts v
};

// over: Inf(i) stands for "part i accepts", Fin(i) for "it does not". All parts over the same variables. One state of
// budget per state; more than Marks::most parts or marks count as too many.
TransitionRelation combination(const std::vector<Part>& parts, const Condition& over, Budget& budget);

}  // namespace waymark::automata
