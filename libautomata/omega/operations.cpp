#include "libautomata/omega/operations.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "libautomata/bdd/joined_alphabet.hpp"
#include "libautomata/omega/product.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// Two automata over the same variables.
struct Aligned {
  JoinedAlphabet alphabet;
  Mtbdd diagram;  // payloads are choices of the automaton whose root it is
  std::vector<Node> first, second;
};

Aligned align(const Automaton& a, const Automaton& b) {
  Aligned out{joined({a.vocabulary(), a.reads()}, {b.vocabulary(), b.reads()}), {}, {}, {}};
  out.first = renamed(a.diagram(), a.transitions().roots, out.alphabet.of_first, out.diagram);
  out.second = renamed(b.diagram(), b.transitions().roots, out.alphabet.of_second, out.diagram);
  return out;
}

// One of the two, over the common variables.
TransitionRelation over(const Aligned& both, const std::vector<Node>& roots, const TransitionRelation& automaton) {
  TransitionRelation out;
  out.diagram = both.diagram;
  out.choices = automaton.choices;
  out.roots = roots;
  out.initial = automaton.initial;
  out.acceptance = automaton.acceptance;
  return out;
}

void require_sets(std::size_t sets) {
  if (sets > Marks::most)
    throw std::length_error("the automaton needs " + std::to_string(sets) + " acceptance sets; 64 are possible");
}

Marks shifted(Marks marks, std::uint32_t by) {
  return by >= Marks::most ? Marks() : Marks::from_bits(marks.bits() << by);
}

std::vector<Branch> moved(std::span<const Branch> branches, std::uint32_t states, std::uint32_t marks, Marks more) {
  std::vector<Branch> out;
  for (const Branch& b : branches) out.push_back({b.target + states, shifted(b.marks, marks) | more});
  return out;
}

// Marks on a loop that the condition rejects, if the two plainest sets tell.
std::optional<Marks> rejecting_marks(const Acceptance& acceptance) {
  for (Marks marks : {Marks(), Marks::first(acceptance.sets)})
    if (!acceptance.condition.holds(marks)) return marks;
  return std::nullopt;
}

// Letters without a branch lead to a state whose loop is rejected: with the marks found, or with a new one, which the
// condition then excludes.
TransitionRelation completed(const TransitionRelation& automaton) {
  if (is_complete(automaton)) return automaton;
  const std::optional<Marks> known = rejecting_marks(automaton.acceptance);
  if (!known) require_sets(std::size_t{automaton.acceptance.sets} + 1);
  const Marks marks = known ? *known : Marks::of(automaton.acceptance.sets);
  std::vector<std::uint32_t> all(automaton.states());
  for (std::uint32_t q = 0; q < all.size(); ++q) all[q] = q;
  const auto sink = static_cast<std::uint32_t>(automaton.states());
  const auto to_sink = [&](std::uint32_t, std::span<const Branch> choice) {
    return choice.empty() ? std::vector<Branch>{{sink, Marks()}} : std::vector<Branch>(choice.begin(), choice.end());
  };
  TransitionRelation out = rebuild(automaton, all, to_sink);
  out.roots.push_back(Mtbdd::terminal(out.choices.intern({{sink, marks}})));
  if (!known) {
    const std::uint32_t mark = out.acceptance.sets++;
    out.acceptance.condition = Condition::all_of({Condition::fin(mark), out.acceptance.condition});
  }
  return out;
}

}  // namespace

Automaton with_edges(const Automaton& automaton, const TransitionRelation& edges) {
  return as_automaton(edges, automaton.vocabulary(), automaton.reads());
}

std::optional<Deterministic> Deterministic::checked(Automaton automaton) {
  if (!is_deterministic(automaton.transitions())) return std::nullopt;
  return Deterministic(std::move(automaton));
}

Automaton intersection(const Automaton& a, const Automaton& b, Budget& budget) {
  const Aligned both = align(a, b);
  return as_automaton(
      intersection(over(both, both.first, a.transitions()), over(both, both.second, b.transitions()), budget),
      both.alphabet.vocabulary, both.alphabet.reads);
}

Deterministic either(const Deterministic& a, const Deterministic& b, Budget& budget) {
  const Automaton neither = intersection(complement(a).automaton(), complement(b).automaton(), budget);
  return complement(*Deterministic::checked(neither));
}

Deterministic complement(const Deterministic& a) {
  TransitionRelation out = completed(a.automaton().transitions());
  out.acceptance.condition = out.acceptance.condition.negated();
  return *Deterministic::checked(with_edges(a.automaton(), out));
}

Automaton sum(const Automaton& a, const Automaton& b) {
  Aligned both = align(a, b);
  const std::uint32_t sets_a = a.acceptance().sets, sets = sets_a + b.acceptance().sets;
  require_sets(std::size_t{sets} + 2);
  const auto states_a = static_cast<std::uint32_t>(a.states());
  const Marks in_a = Marks::of(sets), in_b = Marks::of(sets + 1);
  TransitionRelation out;
  out.acceptance = {
      sets + 2,
      Condition::any_of({Condition::all_of({Condition::inf(sets), a.acceptance().condition}),
                         Condition::all_of({Condition::inf(sets + 1), b.acceptance().condition.shifted(sets_a)})})};
  const auto of_a = [&](std::uint32_t c) { return out.choices.intern(moved(a.transitions().choices[c], 0, 0, in_a)); };
  const auto of_b = [&](std::uint32_t c) {
    return out.choices.intern(moved(b.transitions().choices[c], states_a, sets_a, in_b));
  };
  const auto keep = [](Mtbdd::Variable v) { return v; };
  const auto first = [&](std::uint32_t c) { return Mtbdd::terminal(of_a(c)); };
  const auto second = [&](std::uint32_t c) { return Mtbdd::terminal(of_b(c)); };
  out.roots = out.diagram.import(both.diagram, both.first, first, keep);
  for (Node root : out.diagram.import(both.diagram, both.second, second, keep)) out.roots.push_back(root);
  Budget unlimited;
  const Node start = unite(out, out.diagram.operation(), out.roots[a.initial().index],
                           out.roots[states_a + b.initial().index], unlimited);
  out.initial = static_cast<std::uint32_t>(out.roots.size());
  out.roots.push_back(start);
  return as_automaton(out, both.alphabet.vocabulary, both.alphabet.reads);
}

TransitionRelation renamed(const TransitionRelation& automaton, const std::vector<ltl::Proposition>& from,
                           const std::vector<ltl::Proposition>& to) {
  TransitionRelation out;
  out.choices = automaton.choices;
  out.initial = automaton.initial;
  out.acceptance = automaton.acceptance;
  out.roots = out.diagram.import(
      automaton.diagram, automaton.roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
      [&](Mtbdd::Variable v) {
        return static_cast<Mtbdd::Variable>(std::lower_bound(to.begin(), to.end(), from[v]) - to.begin());
      });
  return out;
}

}  // namespace waymark::automata
