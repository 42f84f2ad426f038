#include "libautomata/deterministic/one_language.hpp"

#include <numeric>
#include <vector>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/inclusion.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {

Branching one_component_each(const Branching& automaton, Effort& effort) {
  const Branching complete = completed_parity(automaton);
  const std::vector<std::vector<bool>> included = inclusions(complete, complete, effort);
  const Components found = components(BranchGraph(complete));
  std::vector<std::uint32_t> all(complete.states()), image(complete.states());
  std::iota(all.begin(), all.end(), 0U);
  image = all;
  for (std::uint32_t q : all)
    for (std::uint32_t r : all)
      if (found.of[r] < found.of[image[q]] && included[q][r] && included[r][q]) image[q] = r;
  Branching out = rebuild(complete, all, [&](std::uint32_t, std::span<const Branch> choice) {
    return std::vector<Branch>{{image[choice.front().target], choice.front().marks}};
  });
  out.initial = image[complete.initial];
  return out;
}

}  // namespace waymark::automata
