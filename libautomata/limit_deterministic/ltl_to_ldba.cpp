#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/limit_deterministic/jump_on_colour.hpp"
#include "libautomata/limit_deterministic/master_theorem.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libautomata/translation/strategies.hpp"
#include "libltl/rewriting/simplify.hpp"

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
constexpr LdbaStrategies strategies;

struct Candidate {
  LimitDeterministic ldba;
  bool reduced = true;
};

template <class Make>
auto within(std::size_t steps, const ltl::Limits& limits, const Make& make)
    -> std::optional<decltype(make(std::declval<Budget&>()))> {
  Budget budget(steps, limits.states, limits.stop);
  try {
    return make(budget);
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    return std::nullopt;
  }
}

bool smaller(const LimitDeterministic& a, const LimitDeterministic& b) {
  return a.automaton.states() < b.automaton.states();
}

class Construction {
 public:
  // parity(Min, Even, ·), deterministic. Throws Budget::Exceeded when the accepting part has more states than the
  // limit.
  Construction(const TransitionRelation& parity, ltl::Limits limits)
      : parity_(completed_parity(parity)),
        limits_(std::move(limits)),
        by_colours_(jump_on_colour(parity_, accepting_part_)) {
    if (too_large()) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    if (parity_.states() <= compared_states) take(compared({by_colours_}));
    if (!best_) {
      Budget budget(SIZE_MAX, SIZE_MAX, limits_.stop);
      best_ = Candidate{assembled(parity_, accepting_part_, {by_colours_}, false, budget).front(), false};
    }
  }
  // Two more ways where the first one has something to jump: its jumps over a larger accepting part, and the theorem's.
  void try_the_theorem(ltl::Formula f, const std::vector<ltl::Proposition>& reads) {
    if (!best_->reduced || parity_.states() > compared_states || is_deterministic()) return;
    auto jumps = within(strategies.theorem.steps, limits_, [&](Budget& budget) {
      return jump_by_master_theorem(f, parity_, reads, accepting_part_, budget);
    });
    if (!jumps || !*jumps || too_large()) return;
    take(compared({by_colours_, **jumps}));
  }
  Candidate best() && { return *std::move(best_); }

 private:
  // Languages compared; none when that takes too much.
  std::vector<LimitDeterministic> compared(std::vector<std::vector<Jump>> jumps) const {
    auto made = within(strategies.colours.steps, limits_, [&](Budget& budget) {
      return assembled(parity_, accepting_part_, std::move(jumps), true, budget);
    });
    return made ? *std::move(made) : std::vector<LimitDeterministic>();
  }
  void take(std::vector<LimitDeterministic> all) {
    for (LimitDeterministic& made : all)
      if (!best_ || smaller(made, best_->ldba)) best_ = Candidate{std::move(made), true};
  }
  bool too_large() const { return accepting_part_.automaton.states() > limits_.states; }
  bool is_deterministic() const {
    for (const auto& jumps : best_->ldba.jumps)
      if (!jumps.empty()) return false;
    return true;
  }

  TransitionRelation parity_;
  ltl::Limits limits_;
  AcceptingPart accepting_part_;
  std::vector<Jump> by_colours_;
  std::optional<Candidate> best_;
};

std::vector<ltl::Proposition> together(std::vector<ltl::Proposition> a, const std::vector<ltl::Proposition>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

}  // namespace

std::variant<TranslatedForMdps, Exhausted> ltl_to_ldba(ltl::Formula f, const ltl::Limits& limits) {
  auto found = ltl_to_parity(f, limits);
  if (const Exhausted* none = std::get_if<Exhausted>(&found)) return *none;
  const Translated& parity = std::get<Translated>(found);
  const ltl::Formula simple = ltl::simplify(f, ltl::Over::Infinite, {}, limits.stop);
  const std::vector<ltl::Proposition> reads = together(ltl::propositions(simple), parity.automaton.reads());
  try {
    const Automaton& from = parity.automaton;
    const TransitionRelation transitions = renamed(from.transitions(), from.reads(), reads);
    Construction construction(min_even_parity(transitions), limits);
    if (!ltl::has_past(simple)) construction.try_the_theorem(simple, reads);
    Candidate best = std::move(construction).best();
    return TranslatedForMdps{ProvedConstructions::made(std::move(best.ldba), f.arena().vocabulary(), reads),
                             best.reduced && parity.reduced};
  } catch (const Budget::Exceeded&) {  // stopped, or the accepting part is too large
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
