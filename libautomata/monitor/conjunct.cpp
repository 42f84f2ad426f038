#include "libautomata/monitor/conjunct.hpp"

#include <optional>

#include "libautomata/monitor/monitor.hpp"
#include "libautomata/omega/weak.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"

namespace waymark::automata {

using ltl::Formula;

namespace {

// Runs of φ and of ¬φ: no run of one is left when every continuation satisfies the other.
struct Sides {
  Part yes, no;
};

std::optional<Sides> of_obligation(Formula f, const ltl::Limits& limits) {
  const std::optional<Transitions> weak = weak_of_obligation(f, limits);
  if (!weak) return std::nullopt;
  const auto side = [&](bool complement) {
    return Part(
        as_automaton(as_buchi(*weak, {.complement = complement}), f.arena().vocabulary(), ltl::propositions(f)));
  };
  return Sides{side(false), side(true)};
}

std::variant<Sides, Exhausted> sides_of(Formula f, Words words, const ltl::Limits& limits) {
  if (words == Words::Finite) {
    const auto made = ltlf_to_dfa(f, limits);
    if (const auto* exhausted = std::get_if<Exhausted>(&made)) return *exhausted;
    const Dfa& dfa = std::get<Dfa>(made);
    return Sides{Part(dfa, false), Part(dfa, true)};
  }
  if (std::optional<Sides> found = of_obligation(f, limits)) return *std::move(found);
  const auto yes = ltl_to_tgba(f, limits), no = ltl_to_tgba(ltl::negate(f), limits);
  for (const auto* side : {&yes, &no})
    if (const auto* exhausted = std::get_if<Exhausted>(side)) return *exhausted;
  return Sides{Part(std::get<Translated>(yes).automaton), Part(std::get<Translated>(no).automaton)};
}

}  // namespace

Part::Place Watched::new_step(Part::Place from, std::uint32_t kind, const ltl::Letter& letter) {
  const Part::Place to = part_.next(from, letter);
  if (from >= steps_.size()) steps_.resize(from + 1);
  if (kind >= steps_[from].size()) steps_[from].resize(kind + 1, unknown);
  return steps_[from][kind] = to;
}

bool Watched::forgets_places() {
  if (part_.places() <= most_places) return false;
  at_ = part_.keep_only(at_);
  steps_.clear();
  return true;
}

std::variant<Conjunct, Exhausted> conjunct_of(Formula f, Words words, const ltl::Limits& limits) {
  try {
    std::variant<Sides, Exhausted> made = sides_of(f, words, limits);
    if (const auto* exhausted = std::get_if<Exhausted>(&made)) return *exhausted;
    Sides& sides = std::get<Sides>(made);
    return Conjunct{Watched(std::move(sides.yes)), Watched(std::move(sides.no)), Kinds(ltl::propositions(f))};
  } catch (const Budget::Exceeded&) {  // stopped
    return Exhausted{};
  }
}

}  // namespace waymark::automata
