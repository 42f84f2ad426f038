#include "libautomata/deterministic/parity.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/fewer_states.hpp"
#include "libautomata/deterministic/one_language.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/scc_filter.hpp"
#include "libautomata/omega/simulation.hpp"
#include "libautomata/omega/weak.hpp"

namespace waymark::automata {
namespace {

constexpr std::size_t merging_steps = 10'000'000;

using Extreme = Acceptance::Extreme;
using Parity = Acceptance::Parity;

std::vector<std::uint32_t> all_states(const TransitionRelation& automaton) {
  std::vector<std::uint32_t> out(automaton.states());
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

// For a weak automaton, in which either all cycles of a component accept or all reject: whether each state accepts.
// Every component gets the largest colour that is at most those of its successors, even if its cycles accept and odd if
// they reject. The states of even colour accept. [Loe01, Sec. 3]
std::vector<bool> weak_acceptance(const TransitionRelation& automaton) {
  const BranchGraph graph(automaton);
  const LiveComponents live = live_components(graph, automaton.acceptance.condition);
  const Components& found = live.components;
  std::vector<std::uint32_t> colour(found.count, 2 * found.count + 2);
  std::vector<bool> out(graph.size());
  for (std::size_t i = 0; i < found.order.size();) {  // successors first
    const std::uint32_t c = found.of[found.order[i]];
    const std::size_t begin = i;
    bool cyclic = false;
    for (; i < found.order.size() && found.of[found.order[i]] == c; ++i)
      for (std::uint32_t r : graph.successors(found.order[i])) {
        if (found.of[r] == c)
          cyclic = true;
        else
          colour[c] = std::min(colour[c], colour[found.of[r]]);
      }
    if (cyclic && (colour[c] % 2 == 0) != live.accepting[c]) --colour[c];
    for (std::size_t j = begin; j < i; ++j) out[found.order[j]] = colour[c] % 2 == 0;
  }
  return out;
}

// The minimal automaton of a weak one: weak_acceptance() makes it a DFA in normal form, which is minimised. [Loe01]
TransitionRelation minimal_weak(const TransitionRelation& automaton, Budget& budget) {
  const TransitionRelation complete = completed_parity(automaton);
  Transitions weak;
  weak.roots = weak.diagram.import(
      complete.diagram, complete.roots,
      [&](std::uint32_t c) { return Mtbdd::terminal(complete.choices[c].front().target); },
      [](Mtbdd::Variable v) { return v; });
  weak.accepting = weak_acceptance(complete);
  weak.initial = complete.initial;
  return as_buchi(minimize(weak, budget), {});
}

// One mark at most on a branch, one branch at most in a choice.
bool has_single_colours(const TransitionRelation& automaton) {
  if (!is_deterministic(automaton)) return false;
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const Branch& b : branches_of(automaton, q))
      if (b.marks.count() > 1) return false;
  return true;
}

std::optional<std::pair<Extreme, Parity>> parity_kind(const Acceptance& acceptance) {
  for (const Extreme extreme : {Extreme::Min, Extreme::Max})
    for (const Parity parity : {Parity::Even, Parity::Odd})
      if (acceptance == Acceptance::parity(extreme, parity, acceptance.sets)) return {{extreme, parity}};
  return std::nullopt;
}

}  // namespace

std::optional<Dpa> Dpa::checked(Automaton automaton) {
  if (!parity_kind(automaton.acceptance()) || !has_single_colours(automaton.transitions())) return std::nullopt;
  return Dpa(std::move(automaton));
}

Reduced reduce_parity(const TransitionRelation& automaton, Budget& budget, std::size_t compared) {
  Reduced out{trim(automaton), true};
  TransitionRelation& live = out.automaton;
  try {
    for (bool merged_all = false;;) {
      const std::size_t states = live.states();
      const Recoloured coloured = with_fewest_colours(live);
      if (coloured.weak) return {with_fewest_colours(minimal_weak(coloured.automaton, budget)).automaton, true};
      live = canonical(bisimulation_quotient(coloured.automaton, budget));
      if (merged_all && live.states() == states) break;  // the structure of which all mergings were tried
      if (live.states() > compared || 2 * live.acceptance.sets > Marks::most) {
        if (live.states() == states) break;
        continue;
      }
      const TransitionRelation complete = completed_parity(live);
      const std::vector<std::uint32_t> language = languages(complete, budget);
      const std::optional<TransitionRelation> moved = one_component_each(complete, language);
      if (moved) live = trim(*moved);
      if (live.states() < states) continue;
      Budget some = budget.at_most(merging_steps);
      Reduced merged = moved ? with_fewer_states(live, some) : with_fewer_states(complete, language, some);
      live = trim(merged.automaton);
      out.complete = merged_all = merged.complete;
      if (live.states() == states) break;
    }
    live = with_fewest_colours(live).automaton;
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    out.complete = false;
  }
  return out;
}

std::size_t count_languages(const TransitionRelation& automaton, Budget& budget) {
  const std::vector<std::uint32_t> first = languages(completed_parity(automaton), budget);
  const auto live = static_cast<std::ptrdiff_t>(automaton.states());
  return std::set<std::uint32_t>(first.begin(), first.begin() + live).size();
}

TransitionRelation complement_parity(const TransitionRelation& automaton) {
  const auto sink = static_cast<std::uint32_t>(automaton.states());
  const std::uint32_t sets = automaton.acceptance.sets + 1;
  if (sets > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  const bool complete = is_complete(automaton);
  TransitionRelation out =
      rebuild(automaton, all_states(automaton), [&](std::uint32_t, std::span<const Branch> choice) {
        if (choice.empty()) return std::vector<Branch>{{sink, {}}};
        const Branch& b = choice.front();
        return std::vector<Branch>{{b.target, mark_of(colour_of(automaton, b.marks) + 1, sets)}};
      });
  out.acceptance = Acceptance::parity(Extreme::Min, Parity::Even, sets);
  if (!complete) out.roots.push_back(Mtbdd::terminal(out.choices.intern({{sink, Marks::of(0)}})));
  return out;
}

// Min odd becomes min even by adding 1 to each colour. Max becomes min by counting colours from the other end, with an
// offset that makes accepting colours even. A branch without a mark has the colour −1.
TransitionRelation min_even_parity(const TransitionRelation& automaton) {
  const auto kind = parity_kind(automaton.acceptance);
  if (!kind) throw std::invalid_argument("not a parity condition");
  const Extreme extreme = kind->first;
  const Parity parity = kind->second;
  if (extreme == Extreme::Min && parity == Parity::Even) return automaton;
  const std::uint32_t sets = automaton.acceptance.sets;
  const std::uint32_t top =  // the colour that 0 becomes when counted from the other end
      sets + (sets % 2 == (parity == Parity::Even ? 0U : 1U) ? 0 : 1);
  const std::uint32_t new_sets = sets + 1 + (extreme == Extreme::Max ? top - sets : 0);
  if (new_sets > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  const auto renamed = [&](std::uint32_t c) { return extreme == Extreme::Min ? c + 1 : top - c; };
  TransitionRelation out =
      rebuild(automaton, all_states(automaton), [&](std::uint32_t, std::span<const Branch> choice) {
        std::vector<Branch> branches;
        for (const Branch& b : choice) {
          const Marks marks = b.marks.empty() ? Marks() : Marks::of(renamed(colour_of(automaton, b.marks)));
          branches.push_back({b.target, marks});
        }
        return branches;
      });
  out.acceptance = Acceptance::parity(Extreme::Min, Parity::Even, new_sets);
  return out;
}

TransitionRelation plain_parity(const TransitionRelation& automaton) {
  const std::uint32_t sets = automaton.acceptance.sets;
  if (sets == 0) return automaton;
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const Branch& b : branches_of(automaton, q))
      if (b.marks.contains(0)) return automaton;
  TransitionRelation out =
      rebuild(automaton, all_states(automaton), [&](std::uint32_t, std::span<const Branch> choice) {
        std::vector<Branch> branches;
        for (const Branch& b : choice) branches.push_back({b.target, Marks::from_bits(b.marks.bits() >> 1U)});
        return branches;
      });
  out.acceptance = Acceptance::parity(Extreme::Min, Parity::Odd, sets - 1);
  return out;
}

TransitionRelation as_rabin(const TransitionRelation& automaton) {
  const std::uint32_t sets = automaton.acceptance.sets, pairs = sets / 2 + 1;
  if (2 * pairs > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
  TransitionRelation out =
      rebuild(automaton, all_states(automaton), [&](std::uint32_t, std::span<const Branch> choice) {
        std::vector<Branch> branches;
        for (const Branch& b : choice) {
          const std::uint32_t colour = colour_of(automaton, b.marks);
          Marks marks = colour % 2 == 0 ? Marks::of(colour + 1) : Marks();
          for (std::uint32_t i = colour / 2 + 1; i < pairs; ++i) marks = marks | Marks::of(2 * i);
          branches.push_back({b.target, marks});
        }
        return branches;
      });
  out.acceptance = Acceptance::rabin(pairs);
  return out;
}

}  // namespace waymark::automata
