#include "libautomata/finite/ltlf_to_dfa.hpp"

#include <stdexcept>
#include <utility>

#include "libautomata/budget.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/portfolio.hpp"

namespace waymark::automata {

using ltl::Formula;

std::variant<Dfa, Exhausted> ltlf_to_dfa(Formula f, const TranslationLimits& limits) {
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
  auto found = ltlf_to_dfa(f, TranslationLimits{.states = SIZE_MAX});
  if (Dfa* dfa = std::get_if<Dfa>(&found)) return std::move(*dfa);
  throw std::length_error("a formula with too many propositions or temporal operators for one automaton");
}

}  // namespace waymark::automata
