#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

#include "libautomata/deterministic/ltl_to_parity.hpp"
#include "libautomata/limit_deterministic/guess_colour.hpp"

namespace waymark::automata {

class ProvedConstructions {
 public:
  static MdpSafe made(LimitDeterministic ldba, const ltl::Vocabulary& vocabulary,
                      const std::vector<ltl::Proposition>& reads) {
    std::vector<ltl::Proposition> kept = keep_asked(ldba.automaton, reads);
    return MdpSafe(std::move(ldba), vocabulary, std::move(kept));
  }
};

namespace {

constexpr std::size_t compared_states = 150;  // of the parity automaton: languages are compared for all pairs
constexpr std::size_t comparison_steps = 100'000'000;

struct Candidate {
  LimitDeterministic ldba;
  bool reduced = true;
};

Candidate by_colours(const Branching& parity, const std::stop_token& stop) {
  if (parity.states() <= compared_states) {
    Effort effort(comparison_steps, SIZE_MAX, stop);
    try {
      return {guess_colour(parity, true, effort), true};
    } catch (const Effort::Spent& spent) {
      if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    }
  }
  Effort effort(SIZE_MAX, SIZE_MAX, stop);
  return {guess_colour(parity, false, effort), false};
}

}  // namespace

std::variant<TranslatedForMdps, Exhausted> ltl_to_ldba(ltl::Formula f, const TranslationLimits& limits) {
  auto found = ltl_to_parity(f, limits);
  if (const Exhausted* none = std::get_if<Exhausted>(&found)) return *none;
  const Translated& parity = std::get<Translated>(found);
  try {
    Candidate best = by_colours(min_even_parity(parity.automaton.transitions()), limits.stop);
    return TranslatedForMdps{
        ProvedConstructions::made(std::move(best.ldba), f.arena().vocabulary(), parity.automaton.reads()),
        best.reduced && parity.reduced};
  } catch (const Effort::Spent&) {
    return Exhausted{parity.automaton.states()};
  }
}

MdpSafe ltl_to_ldba(ltl::Formula f) {
  auto found = ltl_to_ldba(f, {.states = SIZE_MAX});
  if (TranslatedForMdps* made = std::get_if<TranslatedForMdps>(&found)) return std::move(made->automaton);
  throw std::length_error("a formula with too many temporal operators for one automaton");
}

MdpSafe limit_deterministic(const Dpa& automaton) {
  const Automaton& parity = automaton.automaton();
  Candidate made = by_colours(min_even_parity(parity.transitions()), {});
  return ProvedConstructions::made(std::move(made.ldba), parity.vocabulary(), parity.reads());
}

}  // namespace waymark::automata
