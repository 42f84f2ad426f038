#include "libautomata/deterministic/ltl_to_parity.hpp"

#include <array>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/omega/weak.hpp"
#include "libltl/fragment.hpp"
#include "libltl/simplify.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

constexpr std::size_t weak_steps = 400'000'000;
constexpr std::size_t safra_steps = 2'000'000'000;
constexpr std::size_t reduction_steps = 100'000'000;
constexpr std::size_t wait_for = 20;  // times the states that one route needed, while the other one is tried

// Over variables of its own: reads[v] is the proposition of v.
struct Candidate {
  Branching automaton;
  std::vector<ltl::Proposition> reads;
  bool reduced = true;
};

bool smaller(const Candidate& a, const Candidate& b) {
  return std::tuple(a.automaton.states(), count_edges(a.automaton), a.automaton.acceptance.sets) <
         std::tuple(b.automaton.states(), count_edges(b.automaton), b.automaton.acceptance.sets);
}
std::optional<Candidate> smallest(std::optional<Candidate> a, std::optional<Candidate> b) {
  if (!a || (b && smaller(*b, *a))) return b;
  return a;
}

// Of a deterministic generalised Büchi automaton with a set at least, the words that it rejects: generalised co-Büchi.
Branching rejected_by(const Branching& automaton) {
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  const auto sink = static_cast<std::uint32_t>(automaton.states());
  Branching out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    return choice.empty() ? std::vector<Branch>{{sink, {}}}
                          : std::vector<Branch>(choice.begin(), choice.end());
  });
  out.roots.push_back(Mtbdd::terminal(out.choices.intern({{sink, {}}})));
  out.acceptance.condition = out.acceptance.condition.negated();
  return out;
}

class Construction {
 public:
  Construction(Formula f, const TranslationLimits& limits)
      : limits_(limits), formula_(ltl::simplify(f, ltl::Over::Infinite)) {}

  std::optional<Candidate> parity() {
    if (ltl::fragments(formula_, ltl::Semantics::Infinite).obligation) return obligation();
    std::optional<Candidate> best = determinized(buchi(false), limits_.states);
    if (best && best->automaton.states() == 1) return best;
    const std::size_t most =
        best ? std::min(limits_.states, wait_for * best->automaton.states()) : limits_.states;
    if (std::optional<Candidate> dual = determinized(buchi(true), most))
      best = smallest(std::move(best), complement(*dual));
    return best;
  }

  // Or the generalised Büchi automaton of φ or of ¬φ, where it is deterministic as it comes.
  std::optional<Candidate> generic() {
    std::optional<Candidate> best = parity();
    if (const auto& positive = buchi(false); positive && is_deterministic(positive->automaton))
      best = smallest(std::move(best), positive);
    if (const auto& negative = buchi(true);
        negative && negative->automaton.acceptance.sets > 0 && is_deterministic(negative->automaton))
      best = smallest(std::move(best),
                      Candidate{trim(rejected_by(negative->automaton)), negative->reads, negative->reduced});
    return best;
  }

  Translated finish(const Candidate& found) const {
    return {as_automaton(found.automaton, formula_.arena().vocabulary(), found.reads), found.reduced};
  }

 private:
  template <class Make>
  auto within(std::size_t steps, std::size_t states, const Make& make) const
      -> std::optional<decltype(make(std::declval<Effort&>()))> {
    Effort effort(steps, states, limits_.stop);
    try {
      return make(effort);
    } catch (const Effort::Spent& spent) {
      if (spent.reason == Effort::Spent::Reason::Stopped) throw;
      return std::nullopt;
    }
  }
  std::optional<Candidate> obligation() const {
    const std::vector<ltl::Proposition> reads = ltl::propositions(formula_);
    auto weak = within(weak_steps, limits_.states, [&](Effort& effort) {
      return reduce_parity(as_buchi(weak_deterministic(formula_, reads, effort), {}), effort);
    });
    if (!weak) return std::nullopt;
    return Candidate{*std::move(weak), reads, true};
  }
  // The generalised Büchi automaton of φ or of ¬φ.
  const std::optional<Candidate>& buchi(bool negated) {
    std::optional<std::optional<Candidate>>& known = buchi_[negated ? 1 : 0];
    if (known) return *known;
    known.emplace();
    auto found = ltl_to_tgba(negated ? ltl::negate(formula_) : formula_, limits_);
    if (auto* made = std::get_if<Translated>(&found))
      *known = Candidate{made->automaton.transitions(), made->automaton.reads(), made->reduced};
    if (limits_.stop.stop_requested()) throw Effort::Spent{Effort::Spent::Reason::Stopped};
    return *known;
  }
  std::optional<Candidate> determinized(const std::optional<Candidate>& from, std::size_t states) const {
    if (!from) return std::nullopt;
    auto raw = within(safra_steps, states, [&](Effort& effort) {
      return is_deterministic(from->automaton) ? degeneralize_on_edges(from->automaton, effort)
                                               : determinize(from->automaton, effort);
    });
    return raw ? reduced({*std::move(raw), from->reads, from->reduced}) : std::nullopt;
  }
  std::optional<Candidate> complement(const Candidate& from) const {
    return reduced({complement_parity(from.automaton), from.reads, from.reduced});
  }
  std::optional<Candidate> reduced(Candidate raw) const {
    auto out = within(reduction_steps, SIZE_MAX, [&](Effort& e) { return reduce_parity(raw.automaton, e); });
    if (out)
      raw.automaton = *std::move(out);
    else
      raw.reduced = false;
    return raw;
  }

  const TranslationLimits& limits_;
  Formula formula_;
  std::array<std::optional<std::optional<Candidate>>, 2> buchi_;  // asked for; there is one
};

template <class Make>
std::variant<Translated, Exhausted> translate(Formula f, const TranslationLimits& limits, const Make& make) {
  if (ltl::propositions(f).size() > Mtbdd::max_variables) return Exhausted{};
  try {
    Construction construction(f, limits);
    if (std::optional<Candidate> found = make(construction)) return construction.finish(*found);
  } catch (const Effort::Spent&) {  // stopped
  }
  return Exhausted{};
}

}  // namespace

std::variant<Translated, Exhausted> ltl_to_parity(Formula f, const TranslationLimits& limits) {
  return translate(f, limits, [](Construction& construction) {
    std::optional<Candidate> found = construction.parity();
    if (found) found->automaton = plain_parity(found->automaton);
    return found;
  });
}

std::variant<Translated, Exhausted> ltl_to_rabin(Formula f, const TranslationLimits& limits) {
  return translate(f, limits, [](Construction& construction) {
    std::optional<Candidate> found = construction.parity();
    if (found) found->automaton = as_rabin(found->automaton);
    return found;
  });
}

std::variant<Translated, Exhausted> ltl_to_generic(Formula f, const TranslationLimits& limits) {
  return translate(f, limits, [](Construction& construction) { return construction.generic(); });
}

Dpa ltl_to_dpa(Formula f) {
  auto found = ltl_to_parity(f, {.states = SIZE_MAX});
  if (Translated* made = std::get_if<Translated>(&found)) return *Dpa::checked(std::move(made->automaton));
  throw std::length_error("a formula with too many temporal operators for one automaton");
}

}  // namespace waymark::automata
