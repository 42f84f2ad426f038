// What is done to a formula before any automaton is made of it.
#pragma once
#include <stop_token>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::automata {

// Of the same infinite words, in negation normal form. Smaller first, implications found by automata included; then
// what may be looked at late is pulled out (separate.hpp). reads: the propositions of f at least.
ltl::Formula prepared(ltl::Formula f, const std::vector<ltl::Proposition>& reads,
                      const std::stop_token& stop);

}  // namespace waymark::automata
