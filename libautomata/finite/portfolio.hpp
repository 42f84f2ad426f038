// A construction portfolio for the minimal DFA of an LTLf formula: directly (closure under progression, then
// minimisation), or as a product of the minimal automata of the operands.
//
// Neither construction is always better: chains have small closures and large intermediate products, and conjunctions
// of responses the opposite. Both therefore run in rounds, each with four times the steps of the round before. Minimal
// automata and finished products are kept between rounds. Operands are first grouped by shared propositions. The groups
// read disjoint alphabets, where the product is nearly minimal: the direct construction is tried only once, and
// minimisation is skipped where disjoint.hpp proves it useless. Within a group, the smallest automata that share a
// proposition are multiplied first, and each product is minimised. Products of minimal automata: [DF21]; the portfolio
// and the grouping are ours.
#pragma once
#include <cstddef>
#include <vector>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

// Minimal, its states in no particular order, possibly with some that the initial one does not reach; variables are
// positions in `reads`. Throws Budget::Exceeded when no route stays within the limits; made: the states of the
// construction that made most.
Transitions minimal_automaton(ltl::Formula f, const std::vector<ltl::Proposition>& reads, const ltl::Limits& limits,
                              std::size_t& made);

}  // namespace waymark::automata
