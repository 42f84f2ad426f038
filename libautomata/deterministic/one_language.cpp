#include "libautomata/deterministic/one_language.hpp"

#include <numeric>
#include <vector>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/inclusion.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {

std::vector<std::uint32_t> languages(const Branching& complete, Effort& effort) {
  const std::vector<std::vector<bool>> included = inclusions(complete, complete, effort);
  std::vector<std::uint32_t> first(complete.states());
  for (std::uint32_t q = 0; q < first.size(); ++q)
    for (first[q] = 0; first[q] < q; ++first[q])
      if (included[first[q]][q] && included[q][first[q]]) break;
  return first;
}

Branching one_component_each(const Branching& automaton, Effort& effort) {
  const Branching complete = completed_parity(automaton);
  const std::vector<std::uint32_t> language = languages(complete, effort);
  const Components found = components(BranchGraph(complete));
  std::vector<std::uint32_t> all(complete.states()), image(complete.states());
  std::iota(all.begin(), all.end(), 0U);
  image = all;
  for (std::uint32_t q : all)
    for (std::uint32_t r : all)
      if (found.of[r] < found.of[image[q]] && language[q] == language[r]) image[q] = r;
  Branching out = rebuild(complete, all, [&](std::uint32_t, std::span<const Branch> choice) {
    return std::vector<Branch>{{image[choice.front().target], choice.front().marks}};
  });
  out.initial = image[complete.initial];
  return out;
}

}  // namespace waymark::automata
