// Boolean combinations of languages with deterministic automata: the product of the automata, with a condition that
// expresses the combination.
//
// A component automaton is dropped as soon as its verdict is fixed, or as soon as fixed verdicts of others decide the
// combination. A component automaton whose verdict depends only on suffixes of the word is suspended until the product
// of the others enters a strongly connected component in which the verdict matters; it then starts in its initial state
// ([BBDLF13, Sec. 3] for conjunctions). The conditions are not degeneralised: paritise() takes the result.
#pragma once
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/omega/transition_relation.hpp"

namespace waymark::automata {

struct Operand {                 // one language of the combination
  TransitionRelation automaton;  // deterministic, any condition
  bool late = false;             // it accepts uv exactly when it accepts v
};

// over: Inf(i) stands for "part i accepts", Fin(i) for "it does not". All parts over the same variables. One state of
// budget per state; more than Marks::most parts or marks count as too many.
TransitionRelation combination(const std::vector<Operand>& parts, const Condition& over, Budget& budget);

}  // namespace waymark::automata
