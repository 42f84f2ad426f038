#include "libautomata/omega/needless_components.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/greatest_simulation.hpp"
#include "libautomata/omega/scc_filter.hpp"

namespace waymark::automata {
namespace {

// Both automata as one, the states of b after those of a.
Branching beside(const Branching& a, const Branching& b) {
  Branching out;
  out.acceptance = a.acceptance;
  for (const Branching* from : {&a, &b}) {
    const auto offset = static_cast<std::uint32_t>(out.roots.size());
    RootCopier copier(*from, out);
    const auto leaf = [&](std::uint32_t c) {
      std::vector<Branch> branches(from->choices[c].begin(), from->choices[c].end());
      for (Branch& x : branches) x.target += offset;
      return out.choices.intern(std::move(branches));
    };
    for (Mtbdd::Node root : from->roots) out.roots.push_back(copier.copy(root, leaf));
  }
  return out;
}

Branching without(const Branching& automaton, const Components& found, std::uint32_t component) {
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  return rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    std::erase_if(branches, [&](const Branch& b) { return found.of[b.target] == component; });
    return branches;
  });
}

// Components that some branch without a rival leads into. `below` is over the states of `freed`.
std::vector<bool> needed(const Branching& freed, const Components& found, const StatePairs& below) {
  std::vector<bool> out(found.count, false);
  out[found.of[freed.initial]] = true;
  ChoiceLists lists(freed);
  for (std::uint32_t q = 0; q < freed.states(); ++q)
    for (std::uint32_t c : lists.of(q)) {
      const auto choice = freed.choices[c];
      for (const Branch& b : choice) {
        const auto is_rival = [&](const Branch& a) {
          return found.of[a.target] != found.of[b.target] && below(b.target, a.target);
        };
        if (found.of[b.target] != found.of[q] && std::none_of(choice.begin(), choice.end(), is_rival))
          out[found.of[b.target]] = true;
      }
    }
  return out;
}

// The automaton without one component, where there is one to go.
std::optional<Branching> with_one_less(const Branching& automaton, Effort& effort) {
  const std::optional<Branching> freed = with_free_marks(automaton);
  if (!freed) return std::nullopt;
  const Components found = components(BranchGraph(automaton));
  const auto is_needed = [](const std::vector<bool>& by_component) {
    return std::all_of(by_component.begin(), by_component.end(), [](bool yes) { return yes; });
  };
  if (is_needed(needed(*freed, found, StatePairs(freed->states(), true))))
    return std::nullopt;  // cheap, and mostly so
  const std::vector<bool> stays = needed(*freed, found, greatest_simulation(*freed, effort));
  for (std::uint32_t c = 0; c < found.count; ++c) {
    if (stays[c]) continue;
    Branching rest = without(*freed, found, c);
    const auto offset = static_cast<std::uint32_t>(automaton.states());
    if (greatest_simulation(beside(automaton, rest), effort)(automaton.initial, offset + rest.initial))
      return rest;
  }
  return std::nullopt;
}

}  // namespace

Reduced without_needless_components(Branching automaton, Effort& effort) {
  Reduced out{std::move(automaton), true};
  try {
    while (const std::optional<Branching> less = with_one_less(out.automaton, effort))
      out = reduce(*less, MarksOn::Edges, effort);
  } catch (const Effort::Spent& spent) {
    if (spent.reason == Effort::Spent::Reason::Stopped) throw;
    out.complete = false;
  }
  return out;
}

}  // namespace waymark::automata
