// The minimal DFA of an LTLf formula, by whichever of two routes gets there: directly (progression closed off, then
// minimised), or as a product of the minimal automata of its operands.
//
// Neither is always the better one: chains have small closures and large intermediate products, conjunctions of
// responses the other way round. So both work in rounds, a construction having four times as many steps in each round
// as in the one before; minimal automata and finished products are kept from round to round. Operands are first
// grouped by the propositions that they share. Groups read disjoint alphabets, and there the product is as small as it
// can be, nearly: beyond a first attempt the direct route is not tried, and minimising is left out where disjoint.hpp
// proves that it changes nothing. Within a group products are made smallest first, of operands that share a
// proposition, each minimised. Products of minimal automata: [DF21]; the portfolio and the grouping are ours.
#pragma once
#include <cstddef>
#include <vector>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/budget.hpp"
#include "libltl/formula.hpp"

namespace waymark::automata {

struct RouteLimits {
  std::size_t states;    // of one construction, before minimisation
  std::stop_token stop;  // polled at least every few milliseconds
};

// Minimal, its states in no particular order, possibly with some that the initial one does not reach; variables are
// positions in `reads`. Throws Budget::Exceeded when no route stays within the limits; made: the states of the construction
// that made most.
Transitions minimal_automaton(ltl::Formula f, const std::vector<ltl::Proposition>& reads,
                              const RouteLimits& limits, std::size_t& made);

}  // namespace waymark::automata
