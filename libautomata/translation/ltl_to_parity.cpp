#include "libautomata/translation/ltl_to_parity.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "libautomata/deterministic/combination.hpp"
#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/deterministic/paritise.hpp"
#include "libautomata/deterministic/split.hpp"
#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/prepare.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/projection.hpp"
#include "libautomata/omega/recurrence.hpp"
#include "libautomata/omega/scc_filter.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libautomata/omega/weak.hpp"
#include "libautomata/translation/strategies.hpp"
#include "libltl/rewriting/delta2.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/separate.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/rewriting/without_past.hpp"
#include "libltl/structure/hierarchy.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

constexpr ParityStrategies strategies;
constexpr std::size_t small_tableau = 300;     // states that any tableau may have
constexpr std::size_t wait_for = 20;           // times the states of the best one so far, of another one
constexpr std::size_t wait_for_small = 6;      // likewise, where the best one is small enough
constexpr std::size_t small_enough = 24;       // states: the normal form in Δ₂ is not tried, others not for long
constexpr std::size_t most_rewritings = 300;   // to that normal form
constexpr std::size_t compared_at_last = 400;  // states of the smallest one found, languages compared

// Over variables of its own: reads[v] is the proposition of v.
struct Candidate {
  TransitionRelation automaton;
  std::vector<ltl::Proposition> reads;
  bool reduced = true;
  std::optional<bool> minimal = {};  // of a parity automaton, once it has been asked
};

bool smaller(const Candidate& a, const Candidate& b) {
  return std::tuple(a.automaton.states(), count_edges(a.automaton), a.automaton.acceptance.sets) <
         std::tuple(b.automaton.states(), count_edges(b.automaton), b.automaton.acceptance.sets);
}
std::optional<Candidate> smallest(std::optional<Candidate> a, std::optional<Candidate> b) {
  if (!a || (b && smaller(*b, *a))) return b;
  return a;
}

class Construction {
 public:
  // f simplified, in negation normal form.
  Construction(Formula f, const ltl::Limits& limits) : limits_(limits), formula_(f), reads_(ltl::propositions(f)) {}

  // An automaton that is returned because the deadline has passed is not reduced.
  std::optional<Candidate> parity() {
    std::optional<Candidate> best = obligation();
    if (best) return best;
    try {
      search(best);
      if (is_minimal(best)) {
        best->reduced = true;
      } else if (best && best->automaton.states() > compared_states && best->automaton.states() <= compared_at_last) {
        std::optional<Candidate> fewer = reduced(*best, compared_at_last);
        best = smallest(std::move(best), std::move(fewer));
      }
    } catch (const Budget::Exceeded&) {  // stopped
      if (!best) throw;
      best->reduced = false;
    }
    return best;
  }

  // Or an automaton with a deterministic structure and another condition.
  std::optional<Candidate> generic() {
    std::optional<Candidate> best = obligation();
    if (best) return best;
    try {
      for (std::size_t i = 0; i < direct_.size(); ++i) {
        best = smallest(best, direct(i));
        if (best && best->automaton.states() == 1) return best;
      }
      best = smallest(best, parity());
      best = smallest(best, normalised_);
    } catch (const Budget::Exceeded&) {  // stopped
      if (!best) throw;
      best->reduced = false;
    }
    return best;
  }

  Translated finish(const Candidate& found) const {
    return {as_automaton(found.automaton, formula_.arena().vocabulary(), found.reads), found.reduced};
  }

 private:
  template <class Make>
  auto within(std::size_t steps, std::size_t states, const Make& make) const
      -> std::optional<decltype(make(std::declval<Budget&>()))> {
    Budget budget(steps, states, limits_.stop);
    try {
      return make(budget);
    } catch (const Budget::Exceeded& spent) {
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
      return std::nullopt;
    }
  }
  template <class Make>
  auto within(const Strategy& strategy, const Make& make) const {
    return within(strategy.steps, strategy.states == SIZE_MAX ? limits_.states : strategy.states, make);
  }
  // States of an automaton on the way to another one. The normal form's is not the measure of what else there is.
  std::size_t most(const std::optional<Candidate>& best) const {
    if (!best) return limits_.states;
    const std::size_t states = best->automaton.states();
    const std::size_t waited = (states <= small_enough ? wait_for_small : wait_for) * states;
    return std::min(limits_.states, normalised_ ? std::max(next_try(strategies.determinising.states), waited) : waited);
  }
  std::optional<Candidate> obligation() const {
    if (!is_obligation(formula_)) return std::nullopt;
    const auto weak = within(strategies.weak, [&](Budget& budget) {
      return reduce_parity(as_buchi(weak_deterministic(formula_, reads_, budget), {}), budget);
    });
    if (!weak) return std::nullopt;
    return Candidate{weak->automaton, reads_, weak->complete};
  }
  // The generalised Büchi automaton of φ or of ¬φ. Not a much larger one than the product of the parts.
  const std::optional<Candidate>& buchi(bool negated) {
    std::optional<std::optional<Candidate>>& known = buchi_[negated ? 1 : 0];
    if (known) return *known;
    known.emplace();
    ltl::Limits limits = limits_;
    if (const auto& product = direct_[product_of_parts]; product && *product)
      limits.states = std::min(limits.states, std::max(small_tableau, 2 * (*product)->automaton.states()));
    auto found = ltl_to_tgba(negated ? ltl::negate(formula_) : formula_, limits);
    if (auto* made = std::get_if<Translated>(&found))
      *known = Candidate{made->automaton.transitions(), made->automaton.reads(), made->reduced};
    if (limits_.stop.stop_requested()) throw Budget::Exceeded{Budget::Exceeded::Reason::Stopped};
    return *known;
  }
  // A smaller one does not come from a structure that is so much larger: its languages are not compared.
  std::size_t worth_comparing(const std::optional<Candidate>& best) const {
    return best && best->automaton.states() <= small_enough
               ? std::min(compared_states, wait_for_small * best->automaton.states())
               : compared_states;
  }
  // By each route in turn; by determinisation with more and more states, of φ and of ¬φ side by side: unless there is
  // a deterministic automaton already that is no product of parts, which determinisation does not better.
  void search(std::optional<Candidate>& best) {
    const auto keep_smaller = [&](std::optional<Candidate> next) {
      best = smallest(best, std::move(next));
      if (best) best->minimal = has_fewest_states(*best);
    };
    bool is_whole = false;
    for (std::size_t i = 0; i < direct_.size() && !is_minimal(best); ++i)
      if (const std::optional<Candidate>& from = direct(i)) {
        keep_smaller(paritised(*from, worth_comparing(best)));
        is_whole = is_whole || (i != product_of_parts && i != product_of_parts + 1);
      }
    if (best && is_whole) return;
    std::vector<bool> open{false, true};  // negated or not
    for (std::size_t states = strategies.determinising.states; !open.empty() && !is_minimal(best);
         states = next_try(states)) {
      std::vector<bool> still;
      for (const bool negated : open) {
        const std::size_t allowed = std::min(states, most(best));
        std::optional<Candidate> next = determinized(buchi(negated), allowed, worth_comparing(best));
        if (!next && buchi(negated) && allowed < most(best)) still.push_back(negated);
        keep_smaller(next && negated ? complement(*next, worth_comparing(best)) : std::move(next));
        if (is_minimal(best)) return;
      }
      open = std::move(still);
      if (states == strategies.determinising.states && !(best && best->automaton.states() <= small_enough)) {
        normalised_ = normalised();
        if (normalised_) keep_smaller(paritised(*normalised_, worth_comparing(best)));
      }
    }
  }
  static std::size_t next_try(std::size_t states) { return states > SIZE_MAX / 10 ? SIZE_MAX : 10 * states; }
  static bool is_minimal(const std::optional<Candidate>& found) { return found && found->minimal.value_or(false); }
  // As many states as there are languages of states: no deterministic automaton has fewer.
  bool has_fewest_states(const Candidate& found) const {
    if (found.minimal) return *found.minimal;
    if (found.automaton.states() > compared_states) return false;
    const auto all = within(strategies.reduction.steps, SIZE_MAX,
                            [&](Budget& budget) { return count_languages(found.automaton, budget); });
    return all && *all == found.automaton.states();
  }
  // Deterministic automata of φ with any condition, from routes that may have none.
  const std::optional<Candidate>& direct(std::size_t i) {
    if (!direct_[i]) direct_[i].emplace((this->*direct_strategies()[i])());
    return *direct_[i];
  }
  std::optional<Candidate> windows() { return recurrent(false); }
  std::optional<Candidate> windows_of_negation() { return negation(recurrent(true)); }
  std::optional<Candidate> each_part() { return combined(split(Split::Late::Each), strategies.parts); }
  std::optional<Candidate> parts_together() {
    return together_differs() ? combined(split(Split::Late::Together), strategies.parts) : std::nullopt;
  }
  std::optional<Candidate> tableau() { return if_deterministic(buchi(false)); }
  std::optional<Candidate> tableau_of_negation() { return negation(if_deterministic(buchi(true))); }
  // In the order in which they are tried.
  static constexpr std::size_t product_of_parts = 2;  // the place of each_part
  using Direct = std::optional<Candidate> (Construction::*)();
  static constexpr std::array<Direct, 6> direct_strategies() {
    return {&Construction::windows,   &Construction::windows_of_negation,
            &Construction::each_part, &Construction::parts_together,
            &Construction::tableau,   &Construction::tableau_of_negation};
  }
  static std::optional<Candidate> if_deterministic(const std::optional<Candidate>& found) {
    return found && is_deterministic(found->automaton) ? found : std::nullopt;
  }
  static std::optional<Candidate> negation(const std::optional<Candidate>& found) {
    if (!found || found->automaton.acceptance.sets == 0) return std::nullopt;
    return Candidate{trim(rejected_by(found->automaton)), found->reads, found->reduced};
  }
  // G F e₁ ∧ G F e₂ ∧ …, every e co-safe, by the letters that each e may look back at.
  std::optional<Candidate> recurrent(bool negated) const {
    const std::vector<Formula> parts = recurring_parts(negated ? ltl::nnf(ltl::negate(formula_)) : formula_);
    if (parts.empty()) return std::nullopt;
    std::optional<TransitionRelation> out = within(strategies.windows, [&](Budget& budget) {
      std::optional<TransitionRelation> product;
      for (Formula e : parts) {
        std::optional<TransitionRelation> next = recurring(weak_deterministic(e, reads_, budget), budget);
        if (next) *next = bisimulation_quotient(*next, budget);
        if (next && product) next = intersection(*product, *next, budget);
        if (next) product = std::move(next);
      }
      return product ? scc_filter(started_inside(*std::move(product)), MarksOn::Edges, budget) : TransitionRelation();
    });
    if (!out || out->states() == 0) return std::nullopt;
    return Candidate{*std::move(out), reads_, true};
  }
  // A deterministic automaton with any condition, the smallest that comes without determinisation.
  std::optional<Candidate> any() {
    std::optional<Candidate> best = plain();
    return best ? best : parity();
  }
  std::optional<Candidate> plain() {
    std::optional<Candidate> best = obligation();
    if (best) return best;
    for (std::size_t i = 0; i < direct_.size() && !(best && best->automaton.states() == 1); ++i)
      best = smallest(std::move(best), direct(i));
    return best;
  }
  std::optional<Split> split(Split::Late late) const {
    return within(SIZE_MAX, SIZE_MAX, [&](Budget&) { return Split(formula_, late); });
  }
  bool together_differs() const {
    const std::optional<Split> fine = split(Split::Late::Each), coarse = split(Split::Late::Together);
    return !fine || (coarse && fine->parts() != coarse->parts());
  }
  // The product of the parts of the normal form in Δ₂: those of Π₂ have deterministic Büchi automata, those of Σ₂ have
  // them for their negations.
  std::optional<Candidate> normalised() const {
    if (ltl::is_delta2(formula_)) return std::nullopt;
    const std::optional<Formula> form = ltl::delta2(formula_, most_rewritings);
    if (!form) return std::nullopt;
    const Formula shorter =
        ltl::nnf(ltl::separate(ltl::nnf(ltl::simplify(*form, ltl::Over::Infinite, {}, limits_.stop))));
    const Formula normal = ltl::is_delta2(shorter) ? shorter : *form;
    return combined(within(SIZE_MAX, SIZE_MAX, [&](Budget&) { return Split(normal, Split::Late::Each); }),
                    strategies.normal_form, &Construction::plain);
  }
  // The product of deterministic automata of the parts.
  std::optional<Candidate> combined(const std::optional<Split>& split, const Strategy& strategy,
                                    std::optional<Candidate> (Construction::*make)() = &Construction::any) const {
    if (!split || split->parts().size() < 2) return std::nullopt;
    std::vector<Operand> parts;
    bool reduced = true;
    for (Formula g : split->parts()) {
      const std::optional<Candidate> made = (Construction(g, limits_).*make)();
      if (!made) return std::nullopt;
      reduced = reduced && made->reduced;
      parts.push_back({renamed(made->automaton, made->reads, reads_), ltl::purity(g).both()});
    }
    auto product = within(strategy, [&](Budget& budget) { return combination(parts, split->over(), budget); });
    if (!product) return std::nullopt;
    return Candidate{trim(*product), reads_, reduced};
  }
  std::optional<Candidate> paritised(const Candidate& from, std::size_t compared) const {
    auto made = within(strategies.paritising, [&](Budget& e) { return paritise(from.automaton, e); });
    return made ? reduced({*std::move(made), from.reads, from.reduced}, compared) : std::nullopt;
  }
  std::optional<Candidate> determinized(const std::optional<Candidate>& from, std::size_t states,
                                        std::size_t compared) const {
    if (!from) return std::nullopt;
    auto raw = within(strategies.determinising.steps, states, [&](Budget& budget) {
      return is_deterministic(from->automaton) ? degeneralize_on_edges(from->automaton, budget)
                                               : determinize(from->automaton, budget);
    });
    return raw ? reduced({*std::move(raw), from->reads, from->reduced}, compared) : std::nullopt;
  }
  std::optional<Candidate> complement(const Candidate& from, std::size_t compared) const {
    return reduced({complement_parity(from.automaton), from.reads, from.reduced}, compared);
  }
  std::optional<Candidate> reduced(const Candidate& raw, std::size_t compared) const {
    Budget budget(strategies.reduction.steps, SIZE_MAX, limits_.stop);
    Reduced out = reduce_parity(raw.automaton, budget, compared);
    return Candidate{std::move(out.automaton), raw.reads, raw.reduced && out.complete};
  }

  const ltl::Limits& limits_;
  Formula formula_;
  std::vector<ltl::Proposition> reads_;
  std::array<std::optional<std::optional<Candidate>>, 2> buchi_;   // of φ and of ¬φ: asked for; there is one
  std::array<std::optional<std::optional<Candidate>>, 6> direct_;  // likewise
  std::optional<Candidate> normalised_;
};

// Of a formula with past operators, parity(Min, Even, ·): translated with histories, which are forgotten. Where the
// letters read determine the histories, the automaton stays deterministic; else a Büchi automaton is determinised.
std::variant<Translated, Exhausted> with_histories(Formula f, const ltl::Limits& limits) {
  const ltl::Vocabulary& names = f.arena().vocabulary();
  ltl::Arena extended(names);
  const ltl::WithoutPast without = ltl::without_past(f, extended);
  auto found = without.determined ? ltl_to_parity(without.formula, limits) : ltl_to_tgba(without.formula, limits);
  const Translated* made = std::get_if<Translated>(&found);
  if (made == nullptr) return found;
  Budget budget(strategies.determinising.steps, limits.states, limits.stop);
  try {
    return Translated{to_parity(projected(made->automaton, names), budget).automaton(), made->reduced};
  } catch (const Budget::Exceeded&) {
    return Exhausted{budget.states()};
  }
}

// Deterministic, with another condition; `change` gets and gives transitions.
template <class Change>
std::variant<Translated, Exhausted> changed(std::variant<Translated, Exhausted> found, const Change& change) {
  Translated* made = std::get_if<Translated>(&found);
  if (made == nullptr) return found;
  const Automaton& from = made->automaton;
  return Translated{with_edges(from, change(min_even_parity(from.transitions()))), made->reduced};
}

template <class Make>
std::variant<Translated, Exhausted> translate(Formula f, const ltl::Limits& limits, const Make& make) {
  if (ltl::propositions(f).size() > Mtbdd::max_variables) return Exhausted{};
  try {
    const std::vector<ltl::Proposition> reads = ltl::propositions(f);
    Construction construction(prepared(f, reads, limits.stop), limits);
    if (std::optional<Candidate> found = make(construction)) return construction.finish(*found);
  } catch (const Budget::Exceeded&) {  // stopped
  }
  return Exhausted{};
}

}  // namespace

std::variant<Translated, Exhausted> ltl_to_parity(Formula f, const ltl::Limits& limits) {
  if (ltl::has_past(f)) return changed(with_histories(f, limits), plain_parity);
  return translate(f, limits, [](Construction& construction) {
    std::optional<Candidate> found = construction.parity();
    if (found) found->automaton = plain_parity(found->automaton);
    return found;
  });
}

std::variant<Translated, Exhausted> ltl_to_rabin(Formula f, const ltl::Limits& limits) {
  if (ltl::has_past(f)) return changed(with_histories(f, limits), as_rabin);
  return translate(f, limits, [](Construction& construction) {
    std::optional<Candidate> found = construction.parity();
    if (found) found->automaton = as_rabin(found->automaton);
    return found;
  });
}

std::variant<Translated, Exhausted> ltl_to_generic(Formula f, const ltl::Limits& limits) {
  if (ltl::has_past(f)) return ltl_to_parity(f, limits);
  return translate(f, limits, [](Construction& construction) { return construction.generic(); });
}

Dpa ltl_to_dpa(Formula f) {
  auto found = ltl_to_parity(f, {.states = SIZE_MAX});
  if (Translated* made = std::get_if<Translated>(&found)) return *Dpa::checked(std::move(made->automaton));
  throw std::length_error("a formula with too many temporal operators for one automaton");
}

}  // namespace waymark::automata
