#include "libautomata/monitor/monitor.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "libautomata/bdd/transitions.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/omega/prepare.hpp"
#include "libautomata/omega/weak.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/structure/fragment.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
using Set = std::vector<std::uint32_t>;  // of states, sorted

constexpr std::size_t weak_steps = 20'000'000;  // for a deterministic automaton of an obligation

// The subset construction, the empty set accepting.
class Subsets {
 public:
  Subsets(const TransitionRelation& automaton, Budget& budget)
      : automaton_(automaton), budget_(budget), work_(automaton.diagram), unite_(work_.operation()) {
    const Mtbdd::Operation targets = work_.operation();
    const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
      if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
      Set set;
      for (const Branch& b : automaton_.choices[Mtbdd::payload(n[0])]) set.push_back(b.target);
      set.erase(std::unique(set.begin(), set.end()), set.end());  // sorted by target already
      return Mtbdd::terminal(number(std::move(set)));
    };
    for (Node root : automaton.roots) single_.push_back(work_.apply(targets, std::array{root}, decide));
  }

  Transitions build() {
    Transitions out;
    out.initial = number({automaton_.initial});
    std::vector<Node> roots;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const Set set = *sets_[i];
      out.accepting.push_back(set.empty());
      Node all = Mtbdd::terminal(number({}));
      for (std::uint32_t q : set) all = united(all, single_[q]);
      roots.push_back(all);
    }
    out.roots = out.diagram.import(
        work_, roots, [](std::uint32_t set) { return Mtbdd::terminal(set); }, [](Mtbdd::Variable v) { return v; });
    return out;
  }

 private:
  std::uint32_t number(Set set) {
    const auto [at, fresh] = number_.try_emplace(std::move(set), static_cast<std::uint32_t>(sets_.size()));
    if (fresh) {
      budget_.state();
      sets_.push_back(&at->first);
    }
    return at->second;
  }

  Node united(Node f, Node g) {
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      budget_.step();
      if (n[0] == n[1]) return n[0];
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      const Set &a = *sets_[Mtbdd::payload(n[0])], &b = *sets_[Mtbdd::payload(n[1])];
      Set both;
      std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
      return Mtbdd::terminal(number(std::move(both)));
    };
    return work_.apply(unite_, std::array{f, g}, decide);
  }

  const TransitionRelation& automaton_;
  Budget& budget_;
  Mtbdd work_;  // the automaton's diagram, and those whose payloads are sets
  Mtbdd::Operation unite_;
  std::vector<Node> single_;  // by state: the set of its targets
  std::map<Set, std::uint32_t> number_;
  std::vector<const Set*> sets_;
};

bool accepts_nothing(const Automaton& trimmed) {
  return branches_of(trimmed.transitions(), trimmed.initial().index).empty();
}

Dfa of_prefixes(const Transitions& automaton, const ltl::Vocabulary& names, const std::vector<ltl::Proposition>& reads,
                Budget& budget) {
  Transitions minimal = minimize(automaton, budget);
  if (minimal.accepting[minimal.initial]) {  // the empty word is no word
    const Node root = minimal.roots[minimal.initial];
    minimal.initial = static_cast<std::uint32_t>(minimal.roots.size());
    minimal.roots.push_back(root);
    minimal.accepting.push_back(false);
  }
  return as_dfa(canonical(minimal, budget), names, reads);
}

// A minimal weak automaton has one state for each language: the one of nothing, and the one of all words, lead to
// themselves.
bool is_sink(const Transitions& weak, std::uint32_t q, bool accepting) {
  return weak.accepting[q] == accepting && weak.roots[q] == Mtbdd::terminal(q);
}
Monitor of_weak(const Transitions& weak, const ltl::Vocabulary& names, const std::vector<ltl::Proposition>& reads,
                Budget& budget) {
  const auto prefixes = [&](bool accepting) {
    Transitions marked = weak;
    for (std::uint32_t q = 0; q < weak.roots.size(); ++q) marked.accepting[q] = is_sink(weak, q, accepting);
    return of_prefixes(marked, names, reads, budget);
  };
  const Foresight at_first = is_sink(weak, weak.initial, false)  ? Foresight::False
                             : is_sink(weak, weak.initial, true) ? Foresight::True
                                                                 : Foresight::Open;
  Dfa bad = prefixes(false), good = prefixes(true);
  return {std::move(bad), std::move(good), at_first};
}

}  // namespace

Dfa bad_prefixes(const Automaton& trimmed, Budget& budget) {
  return of_prefixes(Subsets(trimmed.transitions(), budget).build(), trimmed.vocabulary(), trimmed.reads(), budget);
}

std::optional<Transitions> weak_of_obligation(ltl::Formula f, const ltl::Limits& limits) {
  if (ltl::has_past(f)) return std::nullopt;
  const std::vector<ltl::Proposition> reads = ltl::propositions(f);
  if (reads.size() > Mtbdd::max_variables) return std::nullopt;
  const ltl::Formula plain = prepared_forms(f, reads, limits.stop).plain;
  if (!ltl::fragments(plain, ltl::Semantics::Infinite).obligation) return std::nullopt;
  Budget budget(weak_steps, limits.states, limits.stop);
  try {
    return weak_deterministic(plain, reads, budget);
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    return std::nullopt;
  }
}

Foresight Monitor::verdict(State q) const {
  if (!q.started) return at_first_;
  if (bad_.is_accepting(q.bad)) return Foresight::False;
  return good_.is_accepting(q.good) ? Foresight::True : Foresight::Open;
}

bool Monitor::is_hopeful(State q) const {
  return verdict(q) == Foresight::Open && (!bad_.is_trap(q.bad) || !good_.is_trap(q.good));
}

std::variant<Monitor, Exhausted> ltl_to_monitor(ltl::Formula f, const ltl::Limits& limits) {
  try {
    Budget budget(SIZE_MAX, limits.states, limits.stop);
    if (const std::optional<Transitions> weak = weak_of_obligation(f, limits))
      return of_weak(*weak, f.arena().vocabulary(), ltl::propositions(f), budget);
  } catch (const Budget::Exceeded&) {  // stopped: minimisation makes no states
    return Exhausted{};
  }
  const auto positive = ltl_to_tgba(f, limits), negative = ltl_to_tgba(ltl::negate(f), limits);
  for (const auto* side : {&positive, &negative})
    if (const auto* exhausted = std::get_if<Exhausted>(side)) return *exhausted;
  const Automaton& of_f = std::get<Translated>(positive).automaton;
  const Automaton& of_not_f = std::get<Translated>(negative).automaton;
  Budget budget(SIZE_MAX, limits.states, limits.stop);
  try {
    Dfa bad = bad_prefixes(of_f, budget), good = bad_prefixes(of_not_f, budget);
    const Foresight at_first = accepts_nothing(of_f)       ? Foresight::False
                               : accepts_nothing(of_not_f) ? Foresight::True
                                                           : Foresight::Open;
    return Monitor(std::move(bad), std::move(good), at_first);
  } catch (const Budget::Exceeded&) {
    return Exhausted{budget.states()};
  }
}

}  // namespace waymark::automata
