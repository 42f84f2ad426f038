// Closed walks of least cost a round: cost over the number of pieces, each meeting every mark, that they can be cut
// into.
//
// On (vertex, marks met in this round) an edge that completes a round starts the next one. The ratio cost / rounds
// falls with every cycle that is negative under costs less the ratio a round, found by relaxation; when none is left
// the last one was the least [DBR67]. Exact where costs are whole numbers; else up to one part in 10⁹.
#pragma once
#include <cstdint>
#include <vector>

#include "libautomata/budget.hpp"
#include "libplan/solve/least_cycle.hpp"

namespace waymark::plan {

// How many rounds the walk completes when it begins one.
std::uint64_t rounds_of(const MarkedGraph& graph, const std::vector<std::uint32_t>& edges);

struct MeanCycle {
  Cycle cycle;               // the walk
  std::uint64_t rounds = 1;  // that walking the cycle again and again completes each time
  double mean() const { return cycle.cost / static_cast<double>(rounds); }  // of a round
};

// `known`: some closed walk that meets every mark. Of all closed walks of least ratio one that begins at the vertex
// nearest by `distance`. Throws what the budget throws.
MeanCycle least_mean_cycle(const MarkedGraph& graph, const AcceptingPart& part, const Cycle& known,
                           const std::vector<double>& distance, automata::Budget& budget);

}  // namespace waymark::plan
