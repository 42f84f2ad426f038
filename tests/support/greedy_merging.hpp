// Merging of states of one language as libautomata/deterministic/fewer_states.hpp defines it, letter by letter and
// cycle by cycle: a second implementation, slow.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace waymark::test {

struct LetterwiseParity {  // deterministic, complete, every state reachable; the least colour decides, even accepts
  struct Step {
    std::uint32_t target, colour;
  };
  std::vector<std::vector<Step>> steps;  // by state, by letter
  std::uint32_t initial = 0;
  std::uint32_t colours = 0;            // the largest colour + 1
  std::vector<std::uint32_t> language;  // by state: equal for states of one language
};

// How many states are reachable when all branches to q are redirected to r for each pair (q, r) in order for which this
// can be coloured, again and again until no pair is left.
std::size_t merged_states(const LetterwiseParity& automaton);

}  // namespace waymark::test
