#include "libautomata/omega/language_merge.hpp"

#include <algorithm>
#include <numeric>

#include "libautomata/omega/emptiness.hpp"
#include "libltl/nnf.hpp"
#include "libltl/random.hpp"

namespace waymark::automata {
namespace {

constexpr std::size_t probes = 64;

bool is_distinct(std::vector<std::uint64_t> verdicts) {
  std::sort(verdicts.begin(), verdicts.end());
  return std::adjacent_find(verdicts.begin(), verdicts.end()) == verdicts.end();
}

// By state: on which of a few lassos u·vʷ over the automaton's variables it accepts.
std::vector<std::uint64_t> verdicts(const Branching& automaton, std::size_t variables) {
  const auto states = static_cast<std::uint32_t>(automaton.states());
  std::vector<std::uint64_t> out(states, 0);
  ltl::Random random(1);  // fixed: same formula, same automaton
  for (std::size_t probe = 0; probe < probes && !is_distinct(out); ++probe) {
    const auto length = static_cast<std::uint32_t>(1 + random.below(4));
    const auto start = static_cast<std::uint32_t>(random.below(length));
    const double density = 0.25 * static_cast<double>(1 + probe % 3);
    BranchGraph graph;  // vertex position · |Q| + q
    for (std::uint32_t i = 0; i < length; ++i) {
      std::vector<bool> letter(variables);
      for (std::size_t v = 0; v < variables; ++v) letter[v] = random.chance(density);
      const std::uint32_t after = (i + 1 < length ? i + 1 : start) * states;
      for (std::uint32_t q = 0; q < states; ++q) {
        graph.add_state();
        const Mtbdd::Node n = automaton.diagram.evaluate(automaton.roots[q],
                                                         [&](Mtbdd::Variable v) { return bool(letter[v]); });
        for (const Branch& b : automaton.choices[Mtbdd::payload(n)])
          graph.add(i * states + q, {after + b.target, b.marks});
      }
    }
    const LiveComponents live = live_components(graph, automaton.acceptance.condition);
    for (std::uint32_t q = 0; q < states; ++q)
      if (live.live[q]) out[q] |= std::uint64_t{1} << probe;
  }
  return out;
}

}  // namespace

Branching merge_equivalent(const Tableau& tableau, const std::vector<ltl::Proposition>& reads,
                           Effort& effort) {
  const Branching& automaton = tableau.automaton;
  const BranchGraph graph(automaton);
  const LiveComponents live = live_components(graph, automaton.acceptance.condition);
  const Components& found = live.components;
  const std::vector<std::uint64_t> verdict = verdicts(automaton, reads.size());
  Satisfiability satisfiable(tableau.meaning.front().arena(), reads, effort);
  const auto includes = [&](ltl::Formula larger, ltl::Formula smaller) {
    return !satisfiable(ltl::nnf(conjunction(smaller, negate(larger))));
  };
  std::vector<std::uint32_t> image(automaton.states());
  std::iota(image.begin(), image.end(), 0U);
  try {
    for (std::size_t i = 0; i < found.order.size(); ++i) {  // successors first
      const std::uint32_t q = found.order[i];
      for (std::size_t j = 0; j < i && image[q] == q && live.live[q]; ++j) {
        const std::uint32_t r = found.order[j];
        if (image[r] != r || found.of[r] == found.of[q] || verdict[q] != verdict[r] || !live.live[r])
          continue;
        const ltl::Formula f = tableau.meaning[q], g = tableau.meaning[r];
        if (includes(f, g) && includes(g, f)) image[q] = r;
      }
    }
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
  }
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  Branching out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = image[b.target];
    return branches;
  });
  out.initial = image[automaton.initial];
  return out;
}

}  // namespace waymark::automata
