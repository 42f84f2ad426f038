#include "libautomata/translation/ltl_to_buchi.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "libautomata/deterministic/determinize.hpp"
#include "libautomata/deterministic/parity.hpp"
#include "libautomata/omega/candidate.hpp"
#include "libautomata/omega/degeneralize.hpp"
#include "libautomata/omega/fewest_marks.hpp"
#include "libautomata/omega/prepare.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/recurrence.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libautomata/omega/state_merging.hpp"
#include "libautomata/omega/suspension.hpp"
#include "libautomata/omega/tableau.hpp"
#include "libautomata/omega/weak.hpp"
#include "libautomata/translation/strategies.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/separate.hpp"
#include "libltl/rewriting/without_past.hpp"
#include "libltl/structure/fragment.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

constexpr BuchiStrategies strategies;
constexpr std::size_t worth_reducing = 8;     // a tableau with more states than so many times a product's
constexpr std::size_t few_states = 50;        // … and this many more is dropped,
constexpr std::size_t many_states = 300;      // … and one with so many that has not fewer than a product
constexpr std::size_t worth_again = 3;        // a second tableau has at most so many times the best one's states
constexpr std::size_t few_again = 8;          // … and this many more
constexpr std::size_t promised_states = 200;  // of a tableau whose marks are tried as they are
constexpr std::size_t merged_languages = 60;  // states of deterministic automata whose languages are compared
// Copies that have more states than the best by a part of that, here and from hopeful_from states on, are not reduced.
constexpr std::size_t hopeful_few = 10, hopeful = 2, hopeful_from = 35;
constexpr std::size_t few_more = 3;        // halves of states that another route may have more by
constexpr std::size_t large_states = 100;  // from here on, one way to count levels instead of all

class Construction {
 public:
  Construction(Formula f, const ltl::Limits& limits, std::size_t& states)
      : limits_(limits),
        reads_(ltl::propositions(f)),
        forms_(prepared_forms(f, reads_, limits.stop)),
        formula_(forms_.separated),
        stated_(ltl::nnf(f)),
        states_(states) {}

  std::optional<Candidate> tgba() {
    std::optional<Candidate> best = smallest_route();
    return best ? least(*best) : std::move(best);
  }

  // From every automaton that a route gave: the smallest generalised one need not be the best to start from.
  std::optional<Candidate> buchi() {
    std::optional<Candidate> general = smallest_route();
    if (!general) return general;
    const Candidate first = least(*general);
    if (first.weak) return first;
    std::optional<Candidate> best;
    if (first.automaton.states() >= large_states) {
      best = counted(first.automaton, {.look_ahead = true}, first.reduced, SIZE_MAX);
    } else {
      put_marks_on_states(first, first.automaton.states(), best);
      for (const Candidate& other : routes_)
        if (other.automaton.states() <= 2 * general->automaton.states())
          put_marks_on_states(other, first.automaton.states(), best);
    }
    if (best) best = with_merged_states(*best, MarksOn::States);
    return general->weak ? smallest(general, std::move(best)) : best;
  }

  Automaton finish(const TransitionRelation& automaton, const ltl::Vocabulary& vocabulary) const {
    return as_automaton(automaton, vocabulary, reads_);
  }

 private:
  std::optional<Candidate> smallest_route() {
    std::optional<Candidate> best = products();
    if (best) most_ = worth_trying(best->automaton.states());
    best = smallest(std::move(best), direct(formula_));
    if (best && !best->weak && best->automaton.states() > 2) {
      std::optional<Candidate> other = unseparated(best->automaton);
      best = smallest(std::move(best), std::move(other));
    }
    return best;
  }

  static std::vector<Formula> conjuncts(Formula f) {
    if (f.op() != ltl::Op::And) return {f};
    return {f.operands().begin(), f.operands().end()};
  }
  // How many states a tableau may have, when a product has so many.
  std::size_t worth_trying(std::size_t states) const {
    return std::min({limits_.states, worth_reducing * states + few_states, std::max(states, many_states)});
  }
  // The smaller one of two products.
  std::optional<Candidate> products() {
    const std::vector<Formula> joined = conjuncts(formula_);
    if (joined.size() < 2 && conjuncts(stated_).size() < 2) return std::nullopt;
    const std::vector<Formula> stated = prepared_operands();
    std::optional<Candidate> best = composed(joined);
    if (best) routes_.push_back(*best);
    if (stated == joined) return best;
    std::optional<Candidate> other = composed(stated);
    if (other) routes_.push_back(*other);
    return smallest(std::move(best), std::move(other));
  }
  // The operands of the formula as it was stated, each made ready by itself: what simplification joins may be smaller
  // as a product of small automata.
  std::vector<Formula> prepared_operands() const {
    std::vector<Formula> out;
    for (Formula g : conjuncts(stated_))
      for (Formula h : conjuncts(prepared_forms(g, reads_, limits_.stop).separated)) out.push_back(h);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }
  // The product of the automata of the operands, reduced at every step: one for all obligations, one for each other
  // operand, what only concerns the far end of the word last.
  std::optional<Candidate> composed(const std::vector<Formula>& operands) {
    std::vector<Formula> late, obligations, parts;
    for (Formula g : operands) {
      const bool obligation = ltl::fragments(g, ltl::Semantics::Infinite).obligation;
      (ltl::purity(g).both() ? late : obligation ? obligations : parts).push_back(g);
    }
    if (!obligations.empty()) parts.insert(parts.begin(), conjunction(formula_.arena(), obligations));
    if (!late.empty()) parts.push_back(conjunction(formula_.arena(), late));
    if (parts.size() < 2) return std::nullopt;
    std::optional<Candidate> product;
    for (Formula g : parts) {
      std::optional<Candidate> next = direct(g);
      if (!next) return std::nullopt;
      product = product ? both(*product, *next, ltl::purity(g).both()) : std::move(next);
      if (!product) return std::nullopt;
    }
    return product;
  }

  // The smallest of some ways to count levels, until one needs no more states than `enough`.
  void put_marks_on_states(const Candidate& general, std::size_t enough, std::optional<Candidate>& best) {
    Budget budget(strategies.simulation.steps, SIZE_MAX, limits_.stop);
    const auto few = within([&] { return fewest_marks(general.automaton, budget); }).value_or(std::nullopt);
    for (const TransitionRelation* from : {&general.automaton, few ? &*few : nullptr})
      for (const LevelRule rule : {LevelRule{false, true, false}, LevelRule{false, false, false},
                                   LevelRule{true, true, false}, LevelRule{true, false, false}}) {
        if (best && best->automaton.states() <= enough) return;
        if (from == nullptr || (rule.descending && from->acceptance.sets < 2)) continue;
        const std::size_t most = best ? worth_reducing_again(best->automaton.states()) : SIZE_MAX;
        std::optional<Candidate> next = counted(*from, rule, general.reduced, most);
        best = smallest(std::move(best), std::move(next));
      }
  }
  static std::size_t worth_reducing_again(std::size_t best) {
    return best + best / (best < hopeful_from ? hopeful_few : hopeful);
  }
  std::optional<Candidate> counted(const TransitionRelation& general, const LevelRule& rule, bool is_reduced,
                                   std::size_t most) {
    Budget budget(strategies.simulation.steps, limits_.states, limits_.stop);
    auto levels = within([&] { return canonical(degeneralize(general, rule, budget)); });
    if (!levels || levels->states() > most) return std::nullopt;
    for (const TransitionRelation& before : counted_)
      if (identical(before, *levels)) return std::nullopt;
    counted_.push_back(*levels);
    Budget rest(std::max(level_steps_, strategies.levels.steps), SIZE_MAX,
                limits_.stop);  // shared by all attempts
    Reduced made = reduce(*levels, MarksOn::States, rest);
    level_steps_ = rest.steps_left();
    return Candidate{std::move(made.automaton), made.complete && is_reduced};
  }

  // The tableau of the formula in which nothing was pulled out, where that makes a difference.
  std::optional<Candidate> unseparated(const TransitionRelation& best) {
    if (forms_.plain == formula_) return std::nullopt;
    const auto raw = raw_tableau(forms_.plain, strategies.second.steps,
                                 std::min({strategies.second.states, most_, worth_again * best.states() + few_again}));
    if (!raw) return std::nullopt;
    routes_.push_back(reduced_tableau(*raw));
    return routes_.back();
  }
  // The minimal weak automaton or the reduced tableau, whichever is smaller.
  std::optional<Candidate> direct(Formula f) {
    if (ltl::fragments(f, ltl::Semantics::Infinite).obligation) return obligation(f);
    const auto raw = raw_tableau(f, strategies.tableau.steps, most_);
    if (!raw) return std::nullopt;
    Candidate first = reduced_tableau(*raw);
    std::optional<Candidate> second = fewer(deterministic(f, first.automaton)), third = fewer(recurring(f));
    if (is_deterministic(first.automaton)) second = smallest(std::move(second), fewer(first));
    if (f == formula_) routes_.push_back(first);
    if (f == formula_ && raw->automaton.acceptance.sets > 1 && raw->automaton.states() <= promised_states)
      routes_.push_back(as_promised(raw->automaton));
    if (f == formula_ && second) routes_.push_back(*second);
    if (f == formula_ && third) routes_.push_back(*third);
    return smallest(smallest(std::move(first), std::move(second)), std::move(third));
  }
  // With the marks that the tableau gave: a mark less may cost an accepting copy less.
  Candidate as_promised(const TransitionRelation& raw) const {
    Budget unlimited;
    return {bisimulation_quotient(trim(raw), unlimited), true};
  }
  // A deterministic Büchi automaton by the means for parity automata, as long as it needs no other colour.
  std::optional<Candidate> fewer(const std::optional<Candidate>& from) const {
    if (!from || from->weak || !is_deterministic(from->automaton)) return from;
    Budget budget(strategies.second.steps, strategies.second.states, limits_.stop);
    try {
      const TransitionRelation parity = degeneralize_on_edges(from->automaton, budget);
      Reduced made = reduce_parity(parity, budget, merged_languages);
      const Acceptance& acceptance = made.automaton.acceptance;
      const bool is_buchi = acceptance.is_buchi() || acceptance.is_all();
      if (is_buchi && smaller(made.automaton, from->automaton)) return Candidate{made.automaton, made.complete};
    } catch (const Budget::Exceeded& spent) {
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    }
    return from;
  }
  std::optional<Candidate> obligation(Formula f) {
    std::optional<Candidate> best;
    if (auto weak = trimmed_weak(f, strategies.tableau.steps, limits_.states))
      best = Candidate{*std::move(weak), true, true};
    // What has an automaton of one state has a minimal deterministic one of one state, if it is an obligation.
    if (best && best->automaton.states() <= 2) return best;
    const std::size_t most = best ? std::min(strategies.second.states, 4 * best->automaton.states()) : limits_.states;
    if (const auto raw = raw_tableau(f, best ? strategies.second.steps : strategies.tableau.steps, most)) {
      if (best && is_deterministic(raw->automaton)) return best;  // nothing deterministic is smaller
      Candidate other = reduced(raw->automaton, MarksOn::Edges);
      if (f == formula_) routes_.push_back(other);
      best = smallest(std::move(best), std::move(other));
    }
    return best;
  }
  // G e₁ ∧ G e₂ ∧ …, every e co-safe and eventual: deterministic, a set for each.
  std::optional<Candidate> recurring(Formula f) {
    std::vector<Formula> parts{f};
    if (f.op() == ltl::Op::And) parts.assign(f.operands().begin(), f.operands().end());
    for (Formula g : parts)
      if (g.op() != ltl::Op::Release || g[0].op() != ltl::Op::False || !ltl::purity(g[1]).eventual ||
          !ltl::fragments(g[1], ltl::Semantics::Infinite).cosafety)
        return std::nullopt;
    return smallest(restarted_each(parts, &Construction::weak_only),
                    restarted_each(parts, &Construction::tableau_only));
  }
  using Route = std::optional<TransitionRelation> (Construction::*)(Formula);
  std::optional<Candidate> restarted_each(const std::vector<Formula>& parts, Route route) {
    std::optional<TransitionRelation> product;
    Budget budget(strategies.second.steps, strategies.second.states, limits_.stop);
    for (Formula g : parts) {
      const std::optional<TransitionRelation> part = (this->*route)(g[1]);
      const std::optional<TransitionRelation> again = part ? restarted(*part) : std::nullopt;
      if (!again) return std::nullopt;
      product = product ? within([&] { return intersection(*product, *again, budget); }) : again;
      if (!product) return std::nullopt;
    }
    return reduced(*std::move(product), MarksOn::Edges);
  }
  std::optional<TransitionRelation> weak_only(Formula f) {
    return trimmed_weak(f, strategies.second.steps, strategies.second.states);
  }
  std::optional<TransitionRelation> tableau_only(Formula f) {
    const auto raw = raw_tableau(f, strategies.second.steps, strategies.second.states);
    if (!raw) return std::nullopt;
    return reduced(raw->automaton, MarksOn::Edges).automaton;
  }
  // The product, reduced; b starts late when it only concerns the far end of the word.
  std::optional<Candidate> both(const Candidate& a, const Candidate& b, bool late) {
    Budget budget(strategies.simulation.steps, limits_.states, limits_.stop);
    const auto product = within([&] {
      return late ? compose_late(a.automaton, b.automaton, budget) : intersection(a.automaton, b.automaton, budget);
    });
    if (!product) return std::nullopt;
    Candidate made = reduced(*product, MarksOn::Edges);
    made.reduced = made.reduced && a.reduced && b.reduced;
    return made;
  }

  // nullopt when a limit is met; being stopped ends the translation.
  template <class Make>
  auto within(const Make& make) -> std::optional<decltype(make())> {
    try {
      return make();
    } catch (const Budget::Exceeded& spent) {
      if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
      return std::nullopt;
    }
  }
  std::optional<Tableau> raw_tableau(Formula f, std::size_t steps, std::size_t most) {
    Budget budget(steps, std::min(most, limits_.states), limits_.stop);
    std::optional<Tableau> made = within([&] { return tableau(f, reads_, budget); });
    states_ = std::max(states_, budget.states());
    return made;
  }
  Candidate reduced_tableau(const Tableau& raw) const {
    Budget budget(strategies.simulation.steps, SIZE_MAX, limits_.stop);
    Reduced out = reduce_as_marked(raw.automaton, budget);
    return {std::move(out.automaton), out.complete};
  }
  Candidate reduced(TransitionRelation automaton, MarksOn marks) const {
    Budget budget(strategies.simulation.steps, SIZE_MAX, limits_.stop);
    Reduced out = reduce(std::move(automaton), marks, budget);
    return {std::move(out.automaton), out.complete};
  }
  std::optional<TransitionRelation> trimmed_weak(Formula f, std::size_t steps, std::size_t states) {
    Budget budget(steps, states, limits_.stop);
    return within([&] { return as_buchi(weak_deterministic(f, reads_, budget), {}); });
  }
  // `automaton` is φ's, by the tableau. One of two states is hardly ever larger than a deterministic one.
  std::optional<Candidate> deterministic(Formula f, const TransitionRelation& automaton) {
    if (automaton.states() <= 2) return std::nullopt;
    Budget budget(strategies.second.steps, strategies.second.states, limits_.stop);
    const auto found =
        within([&] { return on_progression(f, reads_, automaton, outside(f, budget), budget); }).value_or(std::nullopt);
    if (!found) return std::nullopt;
    return found->weak ? Candidate{found->automaton, true, true} : reduced(found->automaton, MarksOn::Edges);
  }
  // Of the words that do not satisfy f, by the tableau. The last one is kept.
  const TransitionRelation& outside(Formula f, Budget& budget) {
    if (!outside_ || outside_->first != f)
      outside_.emplace(f,
                       scc_filter(tableau(ltl::nnf(ltl::negate(f)), reads_, budget).automaton, MarksOn::Edges, budget));
    return outside_->second;
  }
  // Where a deterministic automaton is the smallest, one that is not much larger may be less when its states are
  // merged.
  Candidate least(const Candidate& general) {
    Candidate best = with_merged_states(general, MarksOn::Edges);
    if (!is_deterministic(general.automaton)) return best;
    for (const Candidate& other : routes_) {
      if (2 * other.automaton.states() > 3 * general.automaton.states() + few_more) continue;
      Candidate next = with_merged_states(other, MarksOn::Edges);
      if (smaller(next.automaton, best.automaton)) best = std::move(next);
    }
    return best;
  }
  // Deterministic ones have one state for each language that is left.
  Candidate with_merged_states(const Candidate& from, MarksOn marks) {
    if (from.weak || is_deterministic(from.automaton)) return from;
    Budget budget(strategies.second.steps, strategies.second.states, limits_.stop),
        merging(strategies.merging.steps, SIZE_MAX, limits_.stop);
    const auto out = within([&] { return state_merged(from.automaton, outside(formula_, budget), marks, merging); });
    if (!out) return from;
    const bool is_smaller = smaller(out->automaton, from.automaton);
    return {is_smaller ? out->automaton : from.automaton, out->complete && from.reduced};
  }

  const ltl::Limits& limits_;
  std::vector<ltl::Proposition> reads_;
  Prepared forms_;
  Formula formula_;
  Formula stated_;                     // before anything was done to it
  std::size_t most_ = limits_.states;  // states of a tableau that is worth reducing
  std::size_t level_steps_ = strategies.simulation.steps;
  std::optional<std::pair<Formula, TransitionRelation>> outside_;
  std::vector<TransitionRelation> counted_;  // automata with levels that were reduced already
  std::vector<Candidate> routes_;            // of the whole formula, where there is a choice
  std::size_t& states_;                      // made by the tableau that made most
};

std::variant<Translated, Exhausted> translate(Formula f, const ltl::Limits& limits, bool buchi) {
  if (ltl::has_past(f)) {
    ltl::Arena extended(f.arena().vocabulary());
    auto found = translate(ltl::without_past(f, extended).formula, limits, buchi);
    return forget_histories(std::move(found), f.arena().vocabulary(), buchi, limits);
  }
  std::size_t states = 0;
  if (ltl::propositions(f).size() > Mtbdd::max_variables) return Exhausted{};
  try {
    Construction construction(f, limits, states);
    if (std::optional<Candidate> found = buchi ? construction.buchi() : construction.tgba()) {
      const TransitionRelation result = buchi ? with_one_set(std::move(found->automaton)) : std::move(found->automaton);
      return Translated{construction.finish(result, f.arena().vocabulary()), found->reduced};
    }
  } catch (const Budget::Exceeded&) {  // stopped
  }
  return Exhausted{states};
}

Automaton without_limits(Formula f, bool buchi) {
  auto found = translate(f, {.states = SIZE_MAX}, buchi);
  if (Translated* made = std::get_if<Translated>(&found)) return std::move(made->automaton);
  throw std::length_error("a formula with too many temporal operators for one automaton");
}

}  // namespace

std::variant<Translated, Exhausted> ltl_to_tgba(Formula f, const ltl::Limits& limits) {
  return translate(f, limits, false);
}
std::variant<Translated, Exhausted> ltl_to_buchi(Formula f, const ltl::Limits& limits) {
  return translate(f, limits, true);
}
Automaton ltl_to_tgba(Formula f) { return without_limits(f, false); }
Automaton ltl_to_buchi(Formula f) { return without_limits(f, true); }

}  // namespace waymark::automata
