#include "libautomata/omega/edges.hpp"

#include <algorithm>
#include <array>

namespace waymark::automata {

using Node = Mtbdd::Node;

std::optional<std::size_t> count_edges(const TransitionRelation& automaton, std::size_t most) {
  std::size_t sum = 0;
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    sum += branches_of(automaton, q).size();
    if (sum > most) return std::nullopt;
  }
  return sum;
}

BranchLetters::BranchLetters(const TransitionRelation& automaton)
    : automaton_(automaton), scratch_(automaton.diagram), logic_(scratch_) {}

Node BranchLetters::letters(std::uint32_t source, const Branch& branch) {
  const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
    if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
    const auto choice = automaton_.choices[Mtbdd::payload(n[0])];
    return Boolean::constant(std::binary_search(choice.begin(), choice.end(), branch));
  };
  return scratch_.apply(scratch_.operation(), std::array{automaton_.roots[source]}, decide);
}

std::optional<std::vector<std::vector<BranchEdge>>> edges_by_state(const TransitionRelation& automaton,
                                                                   std::size_t most) {
  if (!count_edges(automaton, most)) return std::nullopt;
  BranchLetters letters(automaton);
  std::vector<std::vector<BranchEdge>> out(automaton.states());
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (const Branch& branch : branches_of(automaton, q)) {
      std::optional<Guard> guard =
          irredundant_cover(letters.diagram(), letters.logic(), letters.letters(q, branch), most);
      if (!guard) return std::nullopt;
      out[q].push_back({branch, std::move(*guard)});
    }
  return out;
}

ltl::Letter letter_of(const Cube& cube, const std::vector<ltl::Proposition>& reads) {
  ltl::Letter out;
  for (const Literal& literal : cube)
    if (literal.positive) out.insert(reads[literal.variable]);
  return out;
}

ltl::Formula to_formula(const Guard& guard, const Automaton& automaton, ltl::Arena& arena) {
  std::vector<ltl::Formula> cubes;
  for (const Cube& cube : guard) {
    std::vector<ltl::Formula> conjuncts;
    for (const Literal& literal : cube) {
      const ltl::Formula atom = arena.atom(automaton.vocabulary().name(automaton.reads()[literal.variable]));
      conjuncts.push_back(literal.positive ? atom : ltl::negate(atom));
    }
    cubes.push_back(ltl::conjunction(arena, conjuncts));
  }
  return ltl::disjunction(arena, cubes);
}

std::size_t count_nodes(const Automaton& automaton) {
  return automaton.diagram().reachable(automaton.transitions().roots).size();
}

}  // namespace waymark::automata
