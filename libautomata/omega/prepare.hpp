// Rewriting of a formula before its translation.
#pragma once
#include <stop_token>
#include <vector>

#include "libltl/formula.hpp"

namespace waymark::automata {

// Of the same infinite words, in negation normal form. Smaller first, implications found by automata included; then
// what may be looked at late is pulled out (separate.hpp). reads: the propositions of f at least.
struct Prepared {
  ltl::Formula separated;  // with eventual and universal parts outside
  ltl::Formula plain;      // before anything was pulled out: its tableau may be the smaller one
};
Prepared prepared_forms(ltl::Formula f, const std::vector<ltl::Proposition>& reads, const std::stop_token& stop);
// The first of both forms.
inline ltl::Formula prepared(ltl::Formula f, const std::vector<ltl::Proposition>& reads, const std::stop_token& stop) {
  return prepared_forms(f, reads, stop).separated;
}

}  // namespace waymark::automata
