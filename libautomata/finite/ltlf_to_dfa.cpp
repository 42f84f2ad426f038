#include "libautomata/finite/ltlf_to_dfa.hpp"

#include <stdexcept>
#include <utility>

#include "libautomata/budget.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/portfolio.hpp"
#include "libautomata/finite/projection.hpp"
#include "libltl/rewriting/without_past.hpp"

namespace waymark::automata {

using ltl::Formula;

namespace {

// Of a formula with past operators: translated with histories, which are forgotten.
std::variant<Dfa, Exhausted> with_histories(Formula f, const ltl::Limits& limits) {
  ltl::Arena extended(f.arena().vocabulary());
  auto found = ltlf_to_dfa(ltl::without_past(f, extended).formula, limits);
  const Dfa* dfa = std::get_if<Dfa>(&found);
  if (dfa == nullptr) return found;
  Budget budget(SIZE_MAX, limits.states, limits.stop);
  try {
    return projected(*dfa, f.arena().vocabulary(), budget);
  } catch (const Budget::Exceeded&) {
    return Exhausted{budget.states()};
  }
}

}  // namespace

std::variant<Dfa, Exhausted> ltlf_to_dfa(Formula f, const ltl::Limits& limits) {
  if (ltl::has_past(f)) return with_histories(f, limits);
  const std::vector<ltl::Proposition> reads = ltl::propositions(f);
  if (reads.size() > Mtbdd::max_variables) return Exhausted{};
  Exhausted spent;
  try {
    const Transitions minimal = minimal_automaton(f, reads, {limits.states, limits.stop}, spent.states);
    Budget budget(SIZE_MAX, SIZE_MAX, limits.stop);
    return as_dfa(canonical(minimal, budget), f.arena().vocabulary(), reads);
  } catch (const Budget::Exceeded&) {
    return spent;
  }
}

Dfa ltlf_to_dfa(Formula f) {
  auto found = ltlf_to_dfa(f, ltl::Limits{.states = SIZE_MAX});
  if (Dfa* dfa = std::get_if<Dfa>(&found)) return std::move(*dfa);
  throw std::length_error("a formula with too many propositions or temporal operators for one automaton");
}

}  // namespace waymark::automata
