#include "libautomata/omega/recurrence.hpp"

#include "libautomata/boolean.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/product.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

Branching without_marks(const Transitions& structure) {
  Branching out;
  const auto leaf = [&](std::uint32_t target) { return Mtbdd::terminal(out.choices.intern({{target, {}}})); };
  out.roots =
      out.diagram.import(structure.diagram, structure.roots, leaf, [](Mtbdd::Variable v) { return v; });
  out.initial = structure.initial;
  return out;
}

// By state of the structure: on which letters its edge lies in an accepting component of the product. The diagram
// receives them, with payloads 0 and 1.
std::vector<Node> taken_by_rejected_words(const Pairs& product, std::size_t states, Mtbdd& diagram,
                                          Effort& effort) {
  const Branching& pairs = product.automaton;
  const LiveComponents live = live_components(BranchGraph(pairs), pairs.acceptance.condition);
  const std::vector<std::uint32_t>& component = live.components.of;
  const std::vector<Node> roots = diagram.import(
      pairs.diagram, pairs.roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
      [](Mtbdd::Variable v) { return v; });
  Boolean logic(diagram);
  std::vector<Node> out(states, Boolean::constant(false));
  for (std::uint32_t i = 0; i < roots.size(); ++i) {
    if (!live.accepting[component[i]]) continue;
    const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
      effort.step();
      if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
      bool inside = false;
      for (const Branch& b : pairs.choices[Mtbdd::payload(n[0])])
        inside = inside || component[b.target] == component[i];
      return Boolean::constant(inside);
    };
    Node& sum = out[product.pairs[i].first];
    sum = logic.disjunction(sum, diagram.apply(diagram.operation(), std::array{roots[i]}, decide));
  }
  return out;
}

}  // namespace

std::optional<Branching> deterministic_buchi(const Transitions& structure, const Branching& yes,
                                             const Branching& no, Effort& effort) {
  const Branching bare = without_marks(structure);
  Branching out;
  out.initial = bare.initial;
  const std::vector<Node> rejected =
      taken_by_rejected_words(pairs_of(bare, no, effort), bare.states(), out.diagram, effort);
  const std::vector<Node> roots = out.diagram.import(
      bare.diagram, bare.roots, [](std::uint32_t choice) { return Mtbdd::terminal(choice); },
      [](Mtbdd::Variable v) { return v; });
  const Mtbdd::Operation mark = out.diagram.operation();
  const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
    effort.step();
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    const Branch edge = bare.choices[Mtbdd::payload(n[0])].front();
    const Marks marks = n[1] == Boolean::constant(true) ? Marks() : Marks::of(0);
    return Mtbdd::terminal(out.choices.intern({{edge.target, marks}}));
  };
  for (std::uint32_t q = 0; q < bare.states(); ++q)
    out.roots.push_back(out.diagram.apply(mark, std::array{roots[q], rejected[q]}, decide));
  out.acceptance = Acceptance::co_buchi();  // its complement: the structure is deterministic and complete
  if (!is_empty(intersection(out, yes, effort))) return std::nullopt;
  out.acceptance = Acceptance::buchi();
  return out;
}

}  // namespace waymark::automata
