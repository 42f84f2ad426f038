#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/ltl_to_parity.hpp"
#include "libautomata/limit_deterministic/guess_colour.hpp"
#include "libautomata/limit_deterministic/master_theorem.hpp"
#include "libautomata/omega/operations.hpp"
#include "libltl/simplify.hpp"

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
constexpr std::size_t comparison_steps = 50'000'000;
constexpr std::size_t theorem_steps = 50'000'000;

struct Candidate {
  LimitDeterministic ldba;
  bool reduced = true;
};

template <class Make>
auto within(std::size_t steps, const TranslationLimits& limits, const Make& make)
    -> std::optional<decltype(make(std::declval<Effort&>()))> {
  Effort effort(steps, limits.states, limits.stop);
  try {
    return make(effort);
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    return std::nullopt;
  }
}

bool smaller(const LimitDeterministic& a, const LimitDeterministic& b) {
  return a.automaton.states() < b.automaton.states();
}

class Construction {
 public:
  // parity(Min, Even, ·), deterministic. Throws Spent when the pool has more states than the limit.
  Construction(const Branching& parity, TranslationLimits limits)
      : parity_(completed_parity(parity)),
        limits_(std::move(limits)),
        by_colours_(guess_colour(parity_, pool_)) {
    if (too_large()) throw Effort::Spent{Effort::Spent::Reason::States};
    if (parity_.states() <= compared_states) take(compared({by_colours_}));
    if (!best_) {
      Effort effort(SIZE_MAX, SIZE_MAX, limits_.stop);
      best_ = Candidate{hosted(parity_, pool_, {by_colours_}, false, effort).front(), false};
    }
  }
  // Two more ways where the first one has something to guess: its guesses over a larger pool, and the theorem's.
  void try_the_theorem(ltl::Formula f, const std::vector<ltl::Proposition>& reads) {
    if (!best_->reduced || parity_.states() > compared_states || is_deterministic()) return;
    auto guesses = within(theorem_steps, limits_, [&](Effort& effort) {
      return guess_by_master_theorem(f, parity_, reads, pool_, effort);
    });
    if (!guesses || !*guesses || too_large()) return;
    take(compared({by_colours_, **guesses}));
  }
  Candidate best() && { return *std::move(best_); }

 private:
  // Languages compared; none when that takes too much.
  std::vector<LimitDeterministic> compared(std::vector<std::vector<Guess>> guesses) const {
    auto made = within(comparison_steps, limits_, [&](Effort& effort) {
      return hosted(parity_, pool_, std::move(guesses), true, effort);
    });
    return made ? *std::move(made) : std::vector<LimitDeterministic>();
  }
  void take(std::vector<LimitDeterministic> all) {
    for (LimitDeterministic& made : all)
      if (!best_ || smaller(made, best_->ldba)) best_ = Candidate{std::move(made), true};
  }
  bool too_large() const { return pool_.automaton.states() > limits_.states; }
  bool is_deterministic() const {
    for (const auto& jumps : best_->ldba.jumps)
      if (!jumps.empty()) return false;
    return true;
  }

  Branching parity_;
  TranslationLimits limits_;
  Pool pool_;
  std::vector<Guess> by_colours_;
  std::optional<Candidate> best_;
};

std::vector<ltl::Proposition> together(std::vector<ltl::Proposition> a,
                                       const std::vector<ltl::Proposition>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

}  // namespace

std::variant<TranslatedForMdps, Exhausted> ltl_to_ldba(ltl::Formula f, const TranslationLimits& limits) {
  auto found = ltl_to_parity(f, limits);
  if (const Exhausted* none = std::get_if<Exhausted>(&found)) return *none;
  const Translated& parity = std::get<Translated>(found);
  const ltl::Formula simple = ltl::simplify(f, ltl::Over::Infinite);
  const std::vector<ltl::Proposition> reads = together(ltl::propositions(simple), parity.automaton.reads());
  try {
    const Automaton& from = parity.automaton;
    const Branching transitions = renamed(from.transitions(), from.reads(), reads);
    Construction construction(min_even_parity(transitions), limits);
    construction.try_the_theorem(simple, reads);
    Candidate best = std::move(construction).best();
    return TranslatedForMdps{ProvedConstructions::made(std::move(best.ldba), f.arena().vocabulary(), reads),
                             best.reduced && parity.reduced};
  } catch (const Effort::Spent&) {  // stopped, or the pool is too large
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
  Candidate made = Construction(min_even_parity(parity.transitions()), {.states = SIZE_MAX}).best();
  return ProvedConstructions::made(std::move(made.ldba), parity.vocabulary(), parity.reads());
}

}  // namespace waymark::automata
